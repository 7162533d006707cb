"""Types of terms, inferred by unification. `term` goes with every type; `region` is `loc`.

A type is a text ("e", "loc", …), ("*", element), ("•", first, second), ("->", from, to) or a Variable.
"""
import re


class Variable:
    def __init__(self):
        self.value = None


class NoType(Exception):
    """The types do not go together."""


class UnknownType(Exception):
    """The log does not tell the type of a name."""


def read_type(text, variables=None):
    tokens = re.findall(r"->|[()*•]|'?\w+", text)
    variables = {} if variables is None else variables

    def arrow():
        left = dotted()
        if tokens and tokens[0] == "->":
            tokens.pop(0)
            return ("->", left, arrow())
        return left

    def dotted():
        first = starred()
        if tokens and tokens[0] == "•":
            tokens.pop(0)
            return ("•", first, starred())
        return first

    def starred():
        token = tokens.pop(0)
        if token == "(":
            inner = arrow()
            tokens.pop(0)
        elif token.startswith("'"):
            inner = variables.setdefault(token, Variable())
        else:
            inner = "loc" if token == "region" else token
        while tokens and tokens[0] == "*":
            tokens.pop(0)
            inner = ("*", inner)
        return inner

    return arrow()


def found(type_):
    while isinstance(type_, Variable) and type_.value is not None:
        type_ = type_.value
    return type_


def unify(a, b):
    a, b = found(a), found(b)
    if a is b or a == "term" or b == "term":
        return
    if isinstance(a, Variable):
        a.value = b
    elif isinstance(b, Variable):
        b.value = a
    elif isinstance(a, str) or isinstance(b, str) or a[0] != b[0]:
        if a != b:
            raise NoType()
    else:
        for one, other in zip(a[1:], b[1:]):
            unify(one, other)


def type_text(type_, level=0):
    """Raises UnknownType where a part is not determined."""
    type_ = found(type_)
    if isinstance(type_, Variable):
        raise UnknownType("an undetermined type")
    if isinstance(type_, str):
        return type_
    if type_[0] == "*":
        return type_text(type_[1], 2) + "*"
    if type_[0] == "•":
        text = f"{type_text(type_[1], 2)} • {type_text(type_[2], 2)}"
        return f"({text})" if level == 2 else text
    text = f"{type_text(type_[1], 1)} -> {type_text(type_[2])}"
    return f"({text})" if level else text


def infer(term, names, bound=()):
    """The type of a term. names(name, applied) gives the type of a name, or raises UnknownType."""
    kind = term[0]
    if kind in ("num", "text"):
        return kind
    if kind == "bool":
        return "t"
    if kind in ("point", "box"):
        return "loc"
    if kind == "null":
        return Variable()
    if kind == "name":
        return names(term[1], False)
    if kind == "var":
        if term[1] >= len(bound):
            raise UnknownType("a free variable")
        return bound[-1 - term[1]]
    if kind == "list":
        element = Variable()
        for part in term[1]:
            unify(element, infer(part, names, bound))
        return ("*", element)
    if kind == "lam":
        own = read_type(term[1].type_text) if term[1].type_text else Variable()
        return ("->", own, infer(term[2], names, (*bound, own)))
    if kind == "app":
        return infer_application(term, names, bound)
    raise UnknownType(kind)


def infer_application(term, names, bound):
    head = term[1]
    type_ = found(names(head[1], True) if head[0] == "name" else infer(head, names, bound))
    for argument in term[2]:
        own = infer(argument, names, bound)
        if type_ == "term":
            return "term"
        if isinstance(type_, Variable):
            result = Variable()
            unify(type_, ("->", own, result))
        elif isinstance(type_, str) or type_[0] != "->":
            raise NoType()
        else:
            unify(type_[1], own)
            result = type_[2]
        type_ = found(result)
    return type_
