"""Acts that were asked for, led back to applications, to the effect that asked, and to inputs."""
import evaluate
import stacks
import terms
from evaluate import Unknown
from machine import flat_effects


def instance(pattern, term, bound):
    """Whether the term is the pattern with something for its variables. A fact of the world stands for any value."""
    if pattern[0] == "var":
        return bound.setdefault(pattern[1], term) == term
    if evaluate.head_of(pattern)[1:2] and evaluate.head_of(pattern)[1] in evaluate.WORLD:
        return True
    if pattern[0] == "app":
        return (term[0] == "app" and len(pattern[2]) == len(term[2])
                and all(instance(a, b, bound) for a, b in zip((pattern[1], *pattern[2]), (term[1], *term[2]))))
    return stacks.near(pattern, term)


def lambdas_in(term):
    if term[0] == "lam":
        yield term
    for part, _ in terms.parts_of(term):
        yield from lambdas_in(part)


class Acts:
    def __init__(self, log):
        self.log, self.applications, self.words = log, [], {}
        self.behind = {}  # record of a register or symbol -> the inputs that it came of

    def inputs_of(self, record):
        """The inputs that the record's `because` leads to, also by way of registers and symbols."""
        found = set()
        for n in record.get("because", []):
            found |= {n} if self.log.records[n]["kind"] == "input" else self.behind.get(n, set())
        return found

    def see(self, record):
        if record["kind"] in ("memory", "symbol"):
            self.behind[record["n"]] = self.inputs_of(record)
        if record["kind"] == "learned" and record["of"] == "word":
            self.words[record["name"]] = terms.read(record["value"])
        elif record["kind"] == "application":
            self.applications.append((terms.read(record["result"]), self.inputs_of(record)))
            self.add_value(*self.applications[-1])
        elif record["kind"] == "act" and record["status"] == "asked":
            self.derive(record)

    def add_value(self, result, because):
        """The result with the functions of the language computed, where it is known."""
        try:
            value = self.log.evaluation({}, {}).value(result)
        except Unknown:
            return
        if not stacks.near(value, result):
            self.applications.append((value, because))

    def derive(self, record):
        self.log.count("acts asked for")
        self.check_inputs(record)
        program = terms.read(record["program"])
        effect = self.effect_that_asks(record, program)
        way = (self.by_application(record, program) or self.by_fact(record, program)
               or self.by_list(record, program) or self.by_instance(record, program)
               or self.by_name(record, program))
        if way is None:
            own = f"the value of the effect {{act: {effect}}}" if effect else "no known effect has this value"
            words = sorted(self.lexicon_words(record))
            if words:
                own += f", perhaps computed by {', '.join(words)} of the lexicon"
            self.log.disagree(record, f"no application leads to {record['program']}, {own}, after {self.said(record)}")
            way = "without derivation"
        self.log.count("acts, " + way)

    def said(self, record):
        """The inputs that led to the act."""
        events = [self.log.records[n]["event"] for n in sorted(self.inputs_of(record))]
        return "; ".join(str(each.get("text") or each.get("name") or each["kind"]) for each in events)

    def check_inputs(self, record):
        """`because` leads to inputs that came before, and the act to one of them by its causes."""
        for n in record["because"]:
            if n >= record["n"] or self.log.records[n]["kind"] not in ("input", "memory", "symbol", "branched"):
                self.log.disagree(record, f"record {n} of `because` is no earlier input, register or symbol")
                return
        if not record["because"]:
            self.log.disagree(record, "`because` is empty")
        root = self.log.readings.input_of(record)
        if root is not None and root not in self.inputs_of(record):
            self.log.disagree(record, f"`because` lacks the input {root}, to which the causes lead")

    def lexicon_words(self, record):
        """Words in applications of the same inputs that may compute."""
        machine = self.log.machine
        known = set(machine.programs) | machine.objects | set(evaluate.TYPES) | set(machine.define) | set(self.words)
        return {name for result, because in self.applications if because <= self.inputs_of(record)
                for name in terms.names_in(result) - known if not result[0] == "name"}

    def effects_of(self, cause):
        """The terms of the acts that a transition and the state that it enters may ask for."""
        machine = self.log.machine
        if cause["kind"] != "transition":
            return []
        effects = [*flat_effects(machine.by_id[cause["id"]].get("do")),
                   *flat_effects(machine.states.get(cause["to"], {}).get("enter"))]
        return [each["act"] for each in effects if "act" in each]

    def effect_that_asks(self, record, program):
        """The term of an effect whose value is the act, or a list that has it; None where none is known."""
        cause, unknown = record.get("caused by") or self.log.records[record["cause"]], None
        for text in self.effects_of(cause):
            try:
                value = self.log.known(text, self.log.moment)
            except Unknown as why:
                unknown = why
                continue
            if any(stacks.near(program, each) for each in self.acts_of(value)):
                self.log.count("acts that are the value of an effect")
                return text
        if unknown or cause["kind"] != "transition":
            self.log.skip("effects that ask", unknown)
        else:
            self.log.disagree(record, f"no effect of '{cause['id']}' or of {cause['to']} has the value "
                                      f"{record['program']}")
        return None

    def acts_of(self, value):
        """The acts that a command stands for: the elements of a list, the acts of a taught word."""
        if value[0] == "list":
            return [act for each in value[1] for act in self.acts_of(each)]
        head = evaluate.head_of(value)
        if value[0] not in ("app", "name") or head[1] not in self.words:
            return [value]
        taught = self.words[head[1]]
        for argument in value[2] if value[0] == "app" else ():
            taught = terms.beta(taught, argument)
        return self.acts_of(taught)

    def by_application(self, record, program):
        found = [because for result, because in self.applications if stacks.near(result, program)]
        if not found:
            return None
        if not any(because <= self.inputs_of(record) for because in found):
            self.log.disagree(record, f"`because` is {record['because']}, the application of that result has "
                                      f"{[sorted(each) for each in found]}")
        return "results of an application"

    def by_fact(self, record, program):
        inputs = self.inputs_of(record)
        for result, because in self.applications:
            if because <= inputs and result[0] == "app" and instance(result, program, {}):
                return "results of an application in which facts of the world were filled in"
        return None

    def by_list(self, record, program):
        """One of several acts that an application made together: of a taught word, or of one sentence."""
        inputs = self.inputs_of(record)
        for result, because in self.applications:
            if because <= inputs and result[0] == "list" and any(
                    stacks.near(program, each) for each in self.acts_of(result)):
                return "elements of the result of an application"
        return None

    def by_name(self, record, program):
        """A name that is applied to nothing, of the machine or taught, and what that name was taught to stand for."""
        if program[0] == "name" and program[1] in self.log.machine.programs:
            return "names that are applied to nothing"
        for taught in self.words.values():
            if taught[0] == "list" and any(stacks.near(program, each) for each in self.acts_of(taught)):
                return "what a taught name stands for"
        return None

    def by_instance(self, record, program):
        """One of several acts: a list whose elements a function in the result of an application makes."""
        inputs = self.inputs_of(record)
        for result, because in self.applications:
            if because <= inputs and any(instance(each[2], program, {}) for each in lambdas_in(result)):
                return "elements that a function in the result of an application makes"
        return None
