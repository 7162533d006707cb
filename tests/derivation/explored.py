"""Under `explore`: the branches that do not lead. Each is followed from where its parent stood, by its own records.

Applications are those of all branches together: what words mean is told once, before the branches part.
"""
import copy

# What a branch has of its own; the rest of a log is common to all.
OWN = ("state", "stack", "ids", "history", "registers", "after_rewrite", "left", "latest", "moment", "offers",
       "before_step")


def standing(log):
    """Where a branch stands: a copy, as far as later steps change it."""
    return {name: copy.copy(getattr(log, name)) for name in OWN}


def stand(log, at):
    for name, value in at.items():
        setattr(log, name, copy.copy(value))


class Branches:
    def __init__(self, log):
        self.log, self.leading, self.stands, self.waiting, self.made = log, 0, {}, [], []
        self.follows = False  # a branch that does not lead is being followed

    def begin_step(self):
        """The leading branch is about to take an input. Without `branches` since, it is the only one."""
        if len(self.stands) < 2:
            self.stands = {self.leading: standing(self.log)}

    def parent_of_leading(self, n):
        """Where the leading branch of the step under way comes from, by the `branches` at its end."""
        for record in self.log.records[n:]:
            if record["kind"] == "branches":
                return record["branches"][0]["parent"]
            if record["kind"] == "input":
                break
        return self.leading

    def lead(self, record):
        """Goes on from where the leading branch's parent stood."""
        parent = self.parent_of_leading(record["n"])
        if parent in self.stands:
            stand(self.log, self.stands[parent])

    def after_step(self, record):
        """A `branches` record: follows the others, and keeps where each stands now."""
        log, before = self.log, self.stands
        if log.records[record["n"] - 1]["kind"] == "refusal":  # the set stays
            return
        now = {record["branches"][0]["id"]: standing(log)}
        leading = now[record["branches"][0]["id"]]
        for branch in record["branches"][1:]:
            log.count("branches followed")
            if branch["parent"] not in before:
                log.disagree(record, f"branch {branch['id']} comes from {branch['parent']}, which is none")
                continue
            stand(log, before[branch["parent"]])
            self.follow([each for each in self.waiting if each["branch"] == branch["id"]])
            self.compare(record, branch)
            now[branch["id"]] = standing(log)
        stand(log, leading)
        self.leading, self.stands, self.waiting = record["branches"][0]["id"], now, []

    def follow(self, way):
        """The records of a branch since the input, as if it led."""
        self.follows, self.made, cause = True, [], None
        for each in way:
            own = {**each["record"], "kind": each["what"], "n": each["n"], "t": each["t"], "because": each["record"].get("because", [])}
            if "cause" in each:
                own["cause"] = each["cause"]
            if cause:
                own["caused by"] = cause
            self.log.count("records of branches that do not lead")
            if each["what"] == "application":
                self.made.append(own)
            elif each["what"] in ("transition", "rewrite"):
                cause = own
            visit = getattr(self.log, "on_" + each["what"], None)
            if visit:
                visit(own)
            if each["what"] in ("transition", "rewrite"):
                self.made = []
            self.log.acts.see(own)
        self.follows = False

    def compare(self, record, branch):
        log, taken = self.log, []
        for each in self.waiting:
            if each["branch"] == branch["id"] and each["what"] == "transition":
                taken.append(each["record"]["id"])
        if taken != branch["by"]:
            log.disagree(record, f"branch {branch['id']} took {branch['by']}, its records tell {taken}")
        if (log.state, log.ids) != (branch["state"], log.chain(branch["stack"])):
            log.disagree(record, f"branch {branch['id']} is in {branch['state']} with the symbol {branch['stack']}, "
                                 f"its records lead to {log.state} with {log.ids[-1]}")
