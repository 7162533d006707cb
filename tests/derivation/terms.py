"""Terms of the notation in run logs: read, printed, substituted. Written from engine/term/term_text.h alone.

A term is a tuple whose first element tells its kind:
  ("num", x)  ("text", s)  ("bool", b)  ("null",)     literals
  ("point", x, y, z)  ("box", low, high)              places; low and high are triples
  ("name", s)                                         a constant, a slot, an object
  ("var", i)                                          a bound variable, counted from the innermost lambda
  ("lam", Hint, body)                                 a lambda of one variable
  ("app", function, (argument, …))                    never an application of an application
  ("list", (element, …))
  ("opaque", s)                                       a value that is not null, of which nothing else is known
  ("opaque or null", s)                               a value that is not known at all
Equal tuples are equal terms: a Hint equals every other, so names of variables do not count.
"""
import re

NULL, TRUE, FALSE = ("null",), ("bool", True), ("bool", False)
TOKEN = re.compile(
    r"\s*(?:(?P<number>\d+(?:\.\d+)?(?:[eE][-+]?\d+)?)|(?P<name>[^\W\d]\w*'*)|'(?P<text>(?:[^'\\]|\\.)*)'"
    r"|`(?P<quoted>(?:[^`\\]|\\.)*)`|(?P<sign>->|!=|<=|>=|[\\λ.,:()\[\]<>=+\-*/•]))")
COMPARISONS = ("=", "!=", "<", "<=", ">", ">=")
LEVELS = [("or",), ("and",), COMPARISONS, ("+", "-"), ("*", "/")]
PREFIX_LEVEL, TIGHT = len(LEVELS), len(LEVELS) + 1


class Hint:
    """The name of a variable and its type, where that is known. All are equal."""

    def __init__(self, name, type_text=None):
        self.name, self.type_text = name, type_text

    def __eq__(self, other):
        return isinstance(other, Hint)

    def __hash__(self):
        return 0

    def __repr__(self):
        return self.name


class NotATerm(Exception):
    """The text is not in the notation."""


def unescaped(text):
    return re.sub(r"\\(.)", r"\1", text)


def tokens_of(text):
    tokens, at = [], 0
    text = text.rstrip()
    while at < len(text):
        match = TOKEN.match(text, at)
        if not match:
            raise NotATerm(f"{text[at:at + 20]!r} in {text!r}")
        kind = match.lastgroup
        tokens.append((kind, match.group(kind), match.start(kind)))
        at = match.end()
    return tokens + [("end", "", len(text))]


def apply(function, arguments):
    arguments = tuple(arguments)
    if not arguments:
        return function
    if function[0] == "app":
        return ("app", function[1], function[2] + arguments)
    return ("app", function, arguments)


class Reader:
    def __init__(self, text):
        self.text, self.tokens, self.at, self.bound = text, tokens_of(text), 0, []

    def peek(self, word=None):
        kind, text, _ = self.tokens[self.at]
        return (kind, text) if word is None else text == word and kind in ("sign", "name")

    def take(self, word=None):
        if word is not None and not self.peek(word):
            raise NotATerm(f"expected {word!r} in {self.text!r}")
        self.at += 1
        return self.tokens[self.at - 1]

    def whole(self):
        term = self.term()
        if self.peek()[0] != "end":
            raise NotATerm(f"more than a term: {self.text!r}")
        return term

    def term(self):
        if self.peek("\\") or self.peek("λ"):
            return self.lambda_term()
        return self.level(0)

    def lambda_term(self):
        self.take()
        names = []
        while self.peek()[0] == "name":
            names.append(self.take()[1])
        type_text = self.annotation() if self.peek(":") else None
        self.take(".")
        self.bound += names
        body = self.term()
        del self.bound[len(self.bound) - len(names):]
        for name in reversed(names):
            body = ("lam", Hint(name, type_text), body)
        return body

    def annotation(self):
        start = self.take(":")[2] + 1
        while not self.peek("."):
            self.take()
        return self.text[start:self.tokens[self.at][2]].strip()

    def level(self, level):
        if level == PREFIX_LEVEL:
            return self.prefix()
        if level == 2 and self.peek("not"):
            self.take()
            return apply(("name", "not"), [self.level(2)])
        left = self.level(level + 1)
        while self.peek()[0] in ("sign", "name") and self.peek()[1] in LEVELS[level]:
            operator = self.take()[1]
            right = self.lambda_term() if self.peek("\\") else self.level(2 if self.peek("not") else level + 1)
            left = apply(("name", operator), [left, right])
        return left

    def prefix(self):
        if self.peek("-"):
            self.take()
            inner = self.prefix()
            return ("num", -inner[1]) if inner[0] == "num" else apply(("name", "negate"), [inner])
        return self.applied(self.atom())

    def applied(self, term):
        while self.peek("("):
            self.take()
            term = apply(term, self.until(")"))
        if term[0] == "app" and term[1] == ("name", "box") and all(part[0] == "point" for part in term[2]):
            return box_of(*term[2])
        return term

    def until(self, end):
        parts = []
        while not self.peek(end):
            parts.append(self.term())
            if not self.peek(end):
                self.take(",")
        self.take(end)
        return parts

    def atom(self):
        kind, text, _ = self.take()
        if kind == "number":
            return ("num", float(text))
        if kind == "text":
            return ("text", unescaped(text))
        if kind == "quoted":
            return ("name", unescaped(text))
        if kind == "name":
            return self.named(text)
        if text == "[":
            return ("list", tuple(self.until("]")))
        if text == "<":
            return self.point()
        if text == "(":
            return self.parenthesis()
        raise NotATerm(f"{text!r} in {self.text!r}")

    def named(self, text):
        if text in ("null", "true", "false"):
            return NULL if text == "null" else ("bool", text == "true")
        if text in self.bound:
            return ("var", self.bound[::-1].index(text))
        return ("name", text)

    def parenthesis(self):
        kind, text, _ = self.tokens[self.at]
        if self.tokens[self.at + 1][1] == ")" and (kind == "sign" or text in ("and", "or", "not")):
            self.at += 2
            return ("name", text)
        term = self.term()
        self.take(")")
        return term

    def point(self):
        parts = []
        for end in (",", ",", ">"):
            parts.append(self.level(3))
            self.take(end)
        if all(part[0] == "num" for part in parts):
            return ("point", *(part[1] for part in parts))
        return apply(("name", "xyz"), parts)


def box_of(a, b):
    low, high = ([extreme(*pair) for pair in zip(a[1:], b[1:])] for extreme in (min, max))
    return ("box", tuple(low), tuple(high))


READ = {}


def read(text):
    if text not in READ:
        READ[text] = Reader(text).whole()
    return READ[text]


def number_text(x):
    if x == int(x) and abs(x) < 1e15:
        return str(int(x))
    return repr(x)


def point_text(xyz):
    return "<" + ", ".join(map(number_text, xyz)) + ">"


def text_of(term, names=()):
    """The term as the log prints it."""
    return printed(term, list(names), 0)


def printed(term, names, level):
    kind = term[0]
    if kind == "num":
        return number_text(term[1])
    if kind == "text":
        return "'" + re.sub(r"(['\\])", r"\\\1", term[1]) + "'"
    if kind == "bool":
        return "true" if term[1] else "false"
    if kind == "point":
        return point_text(term[1:])
    if kind == "box":
        return f"box({point_text(term[1])}, {point_text(term[2])})"
    if kind == "name":
        return name_text(term[1])
    if kind == "var":
        return names[-1 - term[1]] if term[1] < len(names) else f"?{term[1]}"
    if kind == "list":
        return "[" + ", ".join(printed(part, names, 0) for part in term[1]) + "]"
    if kind == "lam":
        text = printed_lambda(term, names)
        return f"({text})" if level else text
    if kind == "app":
        return printed_application(term, names, level)
    return kind


def name_text(name):
    if name in ("and", "or", "not") or not re.fullmatch(r"[^\W\d]\w*'*", name):
        is_operator = any(name in level for level in LEVELS) or name == "not"
        return f"({name})" if is_operator else "`" + re.sub(r"([`\\])", r"\\\1", name) + "`"
    return name


def printed_lambda(term, names):
    shown = []
    while term[0] == "lam":
        name = term[1].name
        used = names_in(term[2]) | {names[-1 - i] for i in free_in(term[2], 1) if i < len(names)}
        while name in used:
            name += "'"
        names = names + [name]
        shown.append(name)
        term = term[2]
    return "\\" + " ".join(shown) + ". " + printed(term, names, 0)


def printed_application(term, names, level):
    function, arguments = term[1], term[2]
    operator = function[1] if function[0] == "name" else None
    if operator == "not" and len(arguments) == 1:
        text = "not " + printed(arguments[0], names, 2)
        return f"({text})" if level > 2 else text
    for own, signs in enumerate(LEVELS):
        if operator in signs and len(arguments) == 2:
            left = printed(arguments[0], names, own)
            text = f"{left} {operator} {printed(arguments[1], names, own + 1)}"
            return f"({text})" if level > own else text
    parts = ", ".join(printed(part, names, 0) for part in arguments)
    return f"{printed(function, names, TIGHT)}({parts})"


def parts_of(term):
    """The terms directly inside, each with the number of lambdas around it there."""
    if term[0] == "lam":
        return [(term[2], 1)]
    if term[0] == "app":
        return [(part, 0) for part in (term[1], *term[2])]
    if term[0] == "list":
        return [(part, 0) for part in term[1]]
    return []


def rebuilt(term, change):
    """The term with each part changed by change(part, lambdas around it)."""
    if term[0] == "lam":
        return ("lam", term[1], change(term[2], 1))
    if term[0] == "app":
        return apply(change(term[1], 0), [change(part, 0) for part in term[2]])
    if term[0] == "list":
        return ("list", tuple(change(part, 0) for part in term[1]))
    return term


def names_in(term):
    if term[0] == "name":
        return {term[1]}
    return set().union(*(names_in(part) for part, _ in parts_of(term)), set())


def free_in(term, depth=0):
    """The free variables, counted from outside of the term."""
    if term[0] == "var":
        return {term[1] - depth} if term[1] >= depth else set()
    return set().union(*(free_in(part, depth + more) for part, more in parts_of(term)), set())


def shifted(term, by, depth=0):
    if by == 0:
        return term
    if term[0] == "var":
        return ("var", term[1] + by) if term[1] >= depth else term
    return rebuilt(term, lambda part, more: shifted(part, by, depth + more))


def substituted(body, argument, depth=0):
    """The body of a lambda with the argument for its variable."""
    if body[0] == "var":
        if body[1] == depth:
            return shifted(argument, depth)
        return ("var", body[1] - 1) if body[1] > depth else body
    return rebuilt(body, lambda part, more: substituted(part, argument, depth + more))


def beta(function, argument):
    """The function of the argument, with all redexes inside reduced."""
    if function[0] == "lam":
        return normal(substituted(function[2], argument))
    return normal(apply(function, [argument]))


def normal(term):
    if term[0] == "app" and term[1][0] == "lam":
        rest = apply(substituted(term[1][2], term[2][0]), term[2][1:])
        return normal(rest)
    return rebuilt(term, lambda part, more: normal(part))


def abstracted(term, part, hint):
    """A lambda of the term without the part, which must be closed; None where it does not occur."""
    def without(inside, depth):
        if inside == part:
            return ("var", depth)
        if inside[0] == "var":
            return ("var", inside[1] + 1) if inside[1] >= depth else inside
        return rebuilt(inside, lambda inner, more: without(inner, depth + more))
    body = without(term, 0)
    return ("lam", hint, body) if 0 in free_in(body) else None
