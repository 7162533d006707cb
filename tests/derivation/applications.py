"""Applications, and pointings among them: a part of rederive.Log."""
import evaluate
import stacks
import terms
import types_of_terms as types
from acts import instance
from evaluate import Unknown


def is_selection(record):
    return record["types"]["argument"] == "e* • loc"


class Applications:
    def on_application(self, record):
        """Is the result the function of the argument, raised by the rule that the record names? Words that compute
        leave an application of a name as it is; below a lambda they may have computed."""
        function, argument, result = (terms.read(record[name]) for name in ("function", "argument", "result"))
        try:
            argument = self.raised_argument(record, argument)
        except Unknown as why:
            self.skip("applications", why)
            return
        self.compare_types(record)
        self.compare_pointing(record)
        reduced = terms.beta(function, argument)
        if stacks.near(reduced, result):
            self.count("applications by β-reduction alone")
            return
        if self.is_pointing(function):
            self.count("applications of [[point]]")
            if not instance(reduced, result, {}):
                self.disagree(record, f"{record['function']} of {terms.text_of(argument)} is not {record['result']}")
            return
        try:
            value = self.evaluation({}, {}).applied(function, [argument])
        except Unknown as why:
            if function[0] != "lam":
                self.disagree(record, f"{record['function']} of {terms.text_of(argument)} is not {record['result']}")
            else:
                self.skip("applications", why)
            return
        self.count("applications by β-reduction and functions of the language")
        if not stacks.near(value, result):
            self.disagree(record, f"{record['function']} of {terms.text_of(argument)} is {terms.text_of(value)}, "
                                  f"the log has {record['result']}")

    @staticmethod
    def is_pointing(function):
        return function[0] == "lam" and evaluate.head_of(function) == ("name", "dot")

    def compare_pointing(self, record):
        """A pointing of which a half is selected came about by an application of [[point]] before."""
        if is_selection(record):
            self.count("halves of pointings selected by type")
            if record["argument"] not in self.pointings:
                self.disagree(record, f"no pointing before it is {record['argument']}")
        elif self.is_pointing(terms.read(record["function"])):
            self.pointings.add(record["result"])

    def raised_argument(self, record, argument):
        if record["rule"] is None:
            return argument
        rule = next((each for each in self.machine.raising["rules"] if each["name"] == record["rule"]), None)
        if rule is None:
            self.disagree(record, f"there is no rule '{record['rule']}'")
            return argument
        self.count("raised arguments")
        self.count(f"raised by {rule['name']}")
        if rule["from"] != record["types"]["argument"]:
            self.disagree(record, f"'{rule['name']}' raises {rule['from']}, not {record['types']['argument']}")
        if record["function"] == rule["by"]:  # the raising itself, of the content of a slot or by the type of words
            return argument
        return self.evaluation({}, {}).raised_by(rule, argument)

    def compare_types(self, record):
        told = record["types"]
        function, argument, result = (types.read_type(told[name]) for name in ("function", "argument", "result"))
        self.count("types of applications")
        try:
            types.unify(function, ("->", argument if record["rule"] is None else types.Variable(), result))
        except types.NoType:
            self.disagree(record, f"the types {record['types']} do not go together")
