"""A machine file as a run log's header has it: which transitions take an input, names and their values, beliefs."""
import evaluate
import terms
import types_of_terms as types
from evaluate import Unknown
from terms import NULL

MOMENT = ("target said why concerned reason gesture confidence pointed_confidence now in_state act meaning reading choices wanted "
          "referents named next previous joined quoted following later unknown repaired left_out pointed pointing move observed_speech observed_gestures "
          "observed_acts looked_at sign sign_at doubted doubted_words doubted_meanings").split()
OPERATIONS = ("none", "push", "push_each", "pop", "rewrite", "rewrite_each", "flush", "pop_until")
PARTICIPANTS = ("avatar", "human")


def listed(value):
    return value if isinstance(value, list) else [value]


def pattern_takes(pattern, symbol):
    if pattern.endswith("\\*"):
        return symbol == pattern[:-2] + "*"
    return symbol.startswith(pattern[:-1]) if pattern.endswith("*") else symbol == pattern


def operation_of(part):
    """The operation of a transition, gate or effect, as the log writes it."""
    return next(({key: part[key]} for key in OPERATIONS if key in part), {"none": True})


def flat_effects(effects):
    for effect in effects or ():
        yield effect
        yield from flat_effects(effect.get("do"))


class Machine:
    def __init__(self, header, raising):
        self.document = header["machine"]["document"]
        self.parameters = header.get("parameters") or {}
        self.raising = raising
        self.objects = set(header["scene"]["bodies"]) | set(PARTICIPANTS)
        self.transitions = self.document["transitions"]
        self.by_id = {each["id"]: each for each in self.transitions}
        self.states = self.document.get("states", {})
        self.slots = {name: each if isinstance(each, dict) else {"type": each}
                      for name, each in self.document.get("slots", {}).items()}
        self.registers = self.document.get("memory", {})
        self.define = self.document.get("define", {})
        self.programs = {**raising["programs"], **self.document.get("programs", {})}
        self.patterns = {}

    def patterns_of(self, name, seen=()):
        """The patterns of an input symbol or of a set's name."""
        members = self.document.get("inputs", {}).get(name)
        if members is None or name in seen:
            return [name]
        return [pattern for each in listed(members) for pattern in self.patterns_of(each, (*seen, name))]

    def takes(self, transition, symbol):
        on = transition["on"]
        if on is None or symbol is None:
            return on is None and symbol is None
        if transition["id"] not in self.patterns:
            self.patterns[transition["id"]] = [each for name in listed(on) for each in self.patterns_of(name)]
        return any(pattern_takes(each, symbol) for each in self.patterns[transition["id"]])

    def fitting(self, state, symbol):
        """The transitions from the state that take the symbol, in file order."""
        return [each for each in self.transitions
                if (each["from"] == "*" or state in listed(each["from"])) and self.takes(each, symbol)]

    def is_input(self, symbol):
        return any(symbol in self.patterns_of(name)
                   for each in self.transitions if each["on"] is not None for name in listed(each["on"]))

    def empty(self, declared):
        return ("list", ()) if declared["type"].endswith("*") else NULL

    def certainty(self, symbol, certainties):
        beliefs = self.document.get("beliefs")
        product = 1.0
        for row in beliefs["evidence"] if beliefs else ():
            if any(pattern_takes(each, symbol) for name in row["inputs"] for each in self.patterns_of(name)):
                for concept in row["concepts"]:
                    related = beliefs["concepts"][concept].get("related", [])
                    product *= max(self.belief(each, certainties) for each in [concept, *related])
        return product

    def belief(self, concept, certainties):
        return certainties.get(concept, self.document["beliefs"]["concepts"][concept].get("fixed", 0.0))


class MachineEvaluation(evaluate.Evaluation):
    """One evaluation: slots of the topmost symbol, registers, and the names of the moment."""

    def __init__(self, machine, slots, registers, moment, certainties, name_types):
        super().__init__(self.find, self.computes_nothing, self.type_of, machine.raising["rules"])
        self.machine, self.slots, self.registers = machine, slots, registers
        self.moment, self.certainties, self.name_types, self.found = moment, certainties, name_types, {}

    def find(self, name):
        if name not in self.found:
            try:
                self.found[name] = self.searched(name)
            except Unknown as why:
                self.found[name] = why
        if isinstance(self.found[name], Unknown):
            raise self.found[name]
        return self.found[name]

    def searched(self, name):
        if name in self.slots:
            return self.slots[name]
        if name in self.registers:
            return self.registers[name]
        if name in self.machine.parameters:
            return constant(self.machine.parameters[name])
        definition = self.machine.define.get(name)
        if isinstance(definition, str):
            return self.value(terms.read(definition))
        if definition is None and (name == "input" or name in MOMENT):
            return self.of_moment(name)
        return None

    def of_moment(self, name):
        value = self.moment.get(name)
        if value is None:
            raise Unknown(f"{name} (the moment)")
        return self.value(value) if name == "meaning" else value

    def computes_nothing(self, name):
        return name in self.machine.programs or name in self.machine.objects

    def type_of(self, name, applied):
        """An object may have the name of a word; only the word is applied."""
        if name in self.machine.programs:
            return types.read_type(self.machine.programs[name])
        if name in self.machine.objects and not applied:
            return "e"
        text = evaluate.TYPES.get(name) or self.name_types.get(name)
        if text is None:
            raise types.UnknownType(name)
        return types.read_type(text)

    def call_values(self, name, values):
        table = self.machine.define.get(name)
        if isinstance(table, dict) or name in ("is_input", "certainty", "wording"):
            if not values or terms.free_in(values[0]):
                return terms.apply(("name", name), values)
            own = self.in_table(table, values[0]) if table else self.of_symbol(name, values[0])
            return self.applied(own, values[1:])
        return super().call_values(name, values)

    def in_table(self, table, key):
        entry = table.get(self.known(key)[1]) if key[0] in ("text", "opaque") and self.known(key) else None
        return NULL if entry is None else self.value(terms.read(entry))

    def of_symbol(self, name, value):
        if name == "wording":
            raise Unknown("wording (phrases)")
        if self.known(value)[0] != "text":
            return NULL
        if name == "is_input":
            return evaluate.boolean(self.machine.is_input(value[1]))
        return ("num", self.machine.certainty(value[1], self.certainties))


def constant(value):
    """A parameter's value as a term."""
    if isinstance(value, bool):
        return ("bool", value)
    return ("text", value) if isinstance(value, str) else ("num", float(value))
