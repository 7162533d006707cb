"""Candidates of a step, which of them was taken, and the gates on the way: a part of rederive.Log."""
import evaluate
from evaluate import Unknown
from machine import operation_of


class Choices:
    def compare_candidates(self, record, place=None):
        place = place or record
        for number, (symbol, moment) in self.offers.items():
            if symbol is None and record["input"] is not None:
                self.skip("candidate lists", "the input symbol of an alternative")
                continue
            logged = {kind: [each["id"] for each in record[kind] if each.get("alternative") == number]
                      for kind in ("candidates", "refused")}
            self.compare_list(place, logged, self.machine.fitting(self.state, symbol), moment)

    def compare_list(self, record, logged, fitting, moment):
        self.count("candidate lists")
        own = [each["id"] for each in fitting]
        if sorted(logged["candidates"] + logged["refused"]) != sorted(own):
            self.disagree(record, f"the log has the transitions {logged}, those of state and input are {own}")
        evaluation = self.evaluation(moment)
        holding = [(each, self.holds(each, evaluation)) for each in fitting]
        self.count("candidate lists of which every condition was checked" if all(holds is not None for _, holds in holding)
                   else "candidate lists checked in part")
        self.compare_conditions(record, logged, holding)

    def holds(self, transition, evaluation):
        """Whether its condition holds, by our own evaluation; None if that is not known."""
        text = transition.get("when")
        if text is None:
            self.count("transitions without a condition")
            return True
        try:
            holds = evaluate.truth(evaluation.known(self.known(text, {}, evaluation)))
        except Unknown as why:
            self.skip("conditions", why)
            return None
        self.count("conditions")
        return holds

    def compare_conditions(self, record, logged, holding):
        """The candidates are those of the highest rank among the transitions whose conditions hold."""
        rank = {each["id"]: each.get("rank", 0) for each, _ in holding}
        highest = max([rank[each["id"]] for each, holds in holding if holds] +
                      [rank[each] for each in logged["candidates"]], default=0)
        for transition, holds in holding:
            name = transition["id"]
            is_candidate = name in logged["candidates"]
            if is_candidate and rank[name] != highest:
                self.disagree(record, f"'{name}' is of rank {rank[name]}, but another candidate is of rank {highest}")
            elif holds is not None and (holds and rank[name] == highest) != is_candidate:
                self.disagree(record, f"the condition of '{name}', {transition.get('when')}, "
                                      f"{'holds' if holds else 'does not hold'}; the log has the opposite")

    def compare_choice(self, record):
        """The weights, and which of the candidates was taken."""
        weights = [each["weight"] for each in record["candidates"]]
        for each in record["candidates"]:
            moment = self.offers.get(each.get("alternative"), (None, {}))[1]
            confidence = moment.get("confidence", ("num", 1.0))[1] if record["input"] is not None else 1.0
            expected = self.machine.by_id[each["id"]].get("weight", 1) * confidence
            self.count("weights")
            if abs(expected - each["weight"]) > 1e-9:
                self.disagree(record, f"the weight of '{each['id']}' is {expected}, the log has {each['weight']}")
        if not weights:
            self.disagree(record, f"'{record['id']}' was taken without a candidate")
        if record["forced"] or self.choice == "explore" or not weights:
            return
        taken = (record["id"], record.get("alternative"))
        keys = [(each["id"], each.get("alternative")) for each in record["candidates"]]
        self.count("choices")
        if taken not in keys:
            self.disagree(record, f"'{record['id']}' is none of the candidates")
        elif self.choice != "sample" and taken != keys[weights.index(max(weights))]:
            self.disagree(record, f"'{record['id']}' was taken, but another candidate is heavier or earlier")
        elif abs(weights[keys.index(taken)] / sum(weights) - record["probability"]) > 1e-9:
            self.disagree(record, f"the probability is not the share of the weights")

    def compare_way(self, record, moment):
        """The gates on the way, the state that they lead to and the operation done."""
        transition = self.machine.by_id[record["id"]]
        to, operation, tested = transition["to"], operation_of(transition), []
        for logged in record["gates"]:
            gate = self.machine.states.get(to, {}).get("gate")
            if logged["state"] != to or not gate:
                self.disagree(record, f"a gate of {logged['state']} was tested on the way to {to}")
                return
            self.compare_gate(record, gate, logged, moment)
            if not logged["passed"]:
                to, operation = gate["else"], operation_of(gate)
            tested.append(logged["passed"])
        if tested and not tested[-1] or not tested:
            if self.machine.states.get(to, {}).get("gate"):
                self.disagree(record, f"the gate of {to} was not tested")
        if to != record["to"]:
            self.disagree(record, f"leads to {to}, the log has {record['to']}")
        if operation != record["operation"]:
            self.disagree(record, f"the operation is {operation}, the log has {record['operation']}")

    def compare_gate(self, record, gate, logged, moment):
        try:
            passed = evaluate.truth(self.known(gate["when"], moment))
        except Unknown as why:
            self.skip("gates", why)
            return
        self.count("gates")
        if passed != logged["passed"]:
            self.disagree(record, f"the gate of {logged['state']}, {gate['when']}, "
                                  f"{'holds' if passed else 'does not hold'}; the log has the opposite")
