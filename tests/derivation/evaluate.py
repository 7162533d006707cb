"""Values of terms, by the tables of engine/term/FUNCTIONS.md. Facts of the world and words of the lexicon are unknown.

Values are normal forms. A value that is not known raises Unknown with the reason; `and`, `or` and `some` are decided
without it where the rest decides them.
"""
import math

import terms
import types_of_terms as types
from terms import FALSE, NULL, TRUE

WORLD = set("scene table held position bounds attribute volume closest located located_roughly "
            "located_loosely as_seen_by common_place offset displaced clear fits free_place learned meaning_of affords "
            "obstacle met".split())
TYPES = {
    "and": "t -> t -> t", "or": "t -> t -> t", "not": "t -> t", "if": "t -> 'a -> 'a -> 'a", "=": "'a -> 'a -> t",
    "!=": "'a -> 'a -> t", "<": "num -> num -> t", "<=": "num -> num -> t", ">": "num -> num -> t",
    ">=": "num -> num -> t", "+": "num -> num -> num", "-": "num -> num -> num", "*": "num -> num -> num",
    "/": "num -> num -> num", "negate": "num -> num", "min": "num -> num -> num", "max": "num -> num -> num",
    "abs": "num -> num", "round": "num -> num", "size": "'a* -> num", "head": "'a* -> 'a", "last": "'a* -> 'a",
    "nth": "'a* -> num -> 'a", "tail": "'a* -> 'a*", "take": "'a* -> num -> 'a*", "append": "'a* -> 'a* -> 'a*",
    "concat": "'a** -> 'a*", "reverse": "'a* -> 'a*", "prefixes": "'a* -> 'a**", "suffixes": "'a* -> 'a**",
    "runs": "'a* -> 'a**",
    "map": "'a* -> ('a -> 'b) -> 'b*", "filter": "'a* -> ('a -> t) -> 'a*", "some": "'a* -> ('a -> t) -> t",
    "every": "'a* -> ('a -> t) -> t", "sort_by": "'a* -> ('a -> num) -> 'a*", "contains": "'a* -> 'a -> t",
    "open": "term -> t", "missing": "term -> text", "type": "term -> text", "fill": "term -> term -> term",
    "each": "'a* -> 'a", "lacking": "term -> term -> term", "program": "term -> text",
    "argument": "term -> num -> term",
    "dot": "e* -> loc -> e* • loc", "things_of": "e* • loc -> e*", "place_of": "e* • loc -> loc",
    "mentions": "term -> text -> t", "text": "term -> text", "place": "term -> loc", "words": "text -> text*",
    "starts_with": "text -> text -> t", "join": "text* -> text -> text", "lower": "text -> text",
    "xyz": "num -> num -> num -> loc", "box": "loc -> loc -> loc", "x": "loc -> num", "y": "loc -> num",
    "z": "loc -> num", "center": "loc -> loc", "low_corner": "loc -> loc", "high_corner": "loc -> loc",
    "extent": "loc -> num", "square": "loc -> num -> loc", "inside": "loc -> loc -> t", "overlap": "loc -> loc -> loc",
    "grow": "loc -> num -> loc", "distance": "loc -> loc -> num", "toward": "loc -> loc -> num -> loc",
    "scene": "e*", "table": "loc", "held": "e", "position": "e -> loc", "bounds": "e -> loc",
    "attribute": "e -> text -> text", "volume": "e -> num", "closest": "e -> loc -> loc", "located": "e -> loc -> t",
    "located_roughly": "e -> loc -> t", "located_loosely": "e -> loc -> t", "as_seen_by": "e -> loc -> loc",
    "common_place": "e -> loc -> loc -> loc", "offset": "e -> text -> num", "displaced": "e -> text -> num -> loc",
    "clear": "e -> num -> t", "fits": "e -> loc -> e* -> t", "free_place": "e -> loc -> loc", "learned": "text -> t",
    "meaning_of": "text -> term", "affords": "e -> text -> t", "obstacle": "t -> text", "met": "loc -> num -> e*",
    "vec": "e -> e -> loc -> loc"}
ARITY = {name: text.replace("('a -> ", "(").count("->") for name, text in TYPES.items()}
COMPUTES_NOTHING = {"each", "dot", "vec"}
MOST_STEPS = 100000


class Unknown(Exception):
    """A value that the log does not tell."""


def truth(value):
    return value == TRUE


def boolean(value):
    return TRUE if value else FALSE


def number(value):
    return ("num", float(value)) if math.isfinite(value) else NULL


def place_of(low, high):
    return ("point", *low) if tuple(low) == tuple(high) else ("box", tuple(low), tuple(high))


def corners(place):
    return (place[1:], place[1:]) if place[0] == "point" else place[1:]


def around(a, b):
    (low_a, high_a), (low_b, high_b) = corners(a), corners(b)
    return place_of(tuple(map(min, low_a, low_b)), tuple(map(max, high_a, high_b)))


def center(place):
    return tuple((a + b) / 2 for a, b in zip(*corners(place)))


def head_of(term):
    while term[0] == "lam":
        term = term[2]
    return term[1] if term[0] == "app" else term


def argument_of(term, at):
    while term[0] == "lam":
        term = term[2]
    if term[0] != "app" or not 0 <= at < len(term[2]):
        return NULL
    part = term[2][int(at)]
    return NULL if terms.free_in(part) else part


def first_place(term):
    if term[0] in ("point", "box"):
        return term
    for part, _ in terms.parts_of(term):
        place = first_place(part)
        if place != NULL:
            return place
    return NULL


def overlap(a, b):
    (low_a, high_a), (low_b, high_b) = corners(a), corners(b)
    low = [max(low_a[i], low_b[i]) for i in (0, 1)]
    high = [min(high_a[i], high_b[i]) for i in (0, 1)]
    if low[0] > high[0] or low[1] > high[1]:
        return NULL
    return place_of((*low, low_a[2]), (*high, high_a[2]))


def grown(place, by):
    low, high = corners(place)
    low, high = (low[0] - by, low[1] - by, low[2]), (high[0] + by, high[1] + by, high[2])
    return NULL if low[0] > high[0] or low[1] > high[1] else place_of(low, high)


def inside(a, b):
    (low_a, high_a), (low_b, high_b) = corners(a), corners(b)
    return all(low_b[i] <= low_a[i] and high_a[i] <= high_b[i] for i in (0, 1))


def toward(a, b, by):
    start, end = center(a), center(b)
    away = math.dist(start, end)
    share = 1 if away <= by else by / away
    return ("point", *(s + (e - s) * share for s, e in zip(start, end)))


NUMBERS = {
    "<": lambda a, b: boolean(a < b), "<=": lambda a, b: boolean(a <= b), ">": lambda a, b: boolean(a > b),
    ">=": lambda a, b: boolean(a >= b), "+": lambda a, b: number(a + b), "-": lambda a, b: number(a - b),
    "*": lambda a, b: number(a * b), "/": lambda a, b: number(a / b) if b else NULL, "negate": lambda a: number(-a),
    "min": lambda a, b: number(min(a, b)), "max": lambda a, b: number(max(a, b)), "abs": lambda a: number(abs(a)),
    "round": lambda a: number(math.copysign(math.floor(abs(a) + 0.5), a)),
    "xyz": lambda x, y, z: ("point", x, y, z)}
PLACES = {
    "box": lambda a, b: around(a, b),
    "x": lambda p: number(center(p)[0]), "y": lambda p: number(center(p)[1]), "z": lambda p: number(center(p)[2]),
    "center": lambda p: ("point", *center(p)), "low_corner": lambda p: ("point", *corners(p)[0]),
    "high_corner": lambda p: ("point", *corners(p)[1]),
    "extent": lambda p: number(max(b - a for a, b in zip(*corners(p)))), "inside": lambda a, b: boolean(inside(a, b)),
    "overlap": overlap, "distance": lambda a, b: number(math.dist(center(a), center(b)))}
LISTS = {
    "size": lambda a: number(len(a)), "head": lambda a: a[0] if a else NULL, "last": lambda a: a[-1] if a else NULL,
    "tail": lambda a: ("list", a[1:]), "reverse": lambda a: ("list", a[::-1]),
    "prefixes": lambda a: ("list", tuple(("list", a[:i + 1]) for i in range(len(a)))),
    "suffixes": lambda a: ("list", tuple(("list", a[i:]) for i in range(len(a)))),
    "runs": lambda a: ("list", tuple(("list", a[i * (i + 1) // 2:(i + 1) * (i + 2) // 2])
                                     for i in range(len(a)) if i * (i + 1) // 2 < len(a)))}
TEXTS = {
    "words": lambda a: ("list", tuple(("text", word) for word in a.split(" ") if word)),
    "starts_with": lambda a, b: boolean(a.startswith(b)), "lower": lambda a: ("text", a.lower())}


class Evaluation:
    """lookup(name) is the value of a slot, a register, a definition …, or None; it may raise Unknown.
    inert(name) tells whether a name is known to compute nothing. type_of_name may raise types.UnknownType.
    raising is a list of rules as in engine/knowledge/raising.json."""

    def __init__(self, lookup=lambda name: None, inert=lambda name: False, type_of_name=None, raising=()):
        self.lookup, self.inert, self.raising, self.steps, self.fills = lookup, inert, raising, 0, []
        self.name_type = type_of_name or (lambda name, applied: types.read_type(TYPES[name]))

    def value(self, term):
        self.steps += 1
        if self.steps > MOST_STEPS:
            raise Unknown("too many steps")
        kind = term[0]
        if kind == "name":
            return self.named(term[1])
        if kind == "list":
            return ("list", tuple(self.value(part) for part in term[1]))
        if kind == "lam":
            return ("lam", term[1], self.under_lambda(term[2]))
        if kind == "app":
            return self.application(term)
        return term

    def under_lambda(self, body):
        return self.value(body)

    def named(self, name):
        found = self.lookup(name)
        if found is not None:
            return self.known_at_all(found)
        if name in WORLD and ARITY[name] == 0:
            raise Unknown(f"{name} (the world)")
        return ("name", name)

    def application(self, term):
        function = term[1]
        if function[0] == "name":
            found = self.lookup(function[1])
            if found is None:
                return self.call(function[1], term[2])
            function = found
        elif function[0] not in ("var",):
            function = self.value(function)
        return self.applied(function, [self.value(part) for part in term[2]])

    def applied(self, function, arguments):
        for at, argument in enumerate(arguments):
            if function[0] == "lam":
                function = self.value(terms.substituted(function[2], argument))
            elif function[0] == "name" or function[0] == "app" and function[1][0] == "name":
                given = function[2] if function[0] == "app" else ()
                name = function[1][1] if function[0] == "app" else function[1]
                return self.call_values(name, [*given, *arguments[at:]])
            elif function[0] == "var" or function[0] == "app":
                return terms.apply(function, arguments[at:])
            elif function == NULL:
                return NULL
            else:
                raise Unknown(f"an application of a {function[0]}")
        return function

    def call(self, name, arguments):
        if name == "if" and len(arguments) >= 3:
            condition = self.value(arguments[0])
            if terms.free_in(condition):
                return terms.apply(("name", "if"), [condition, *map(self.value, arguments[1:])])
            chosen = self.value(arguments[1] if truth(condition) else arguments[2])
            return self.applied(chosen, [self.value(part) for part in arguments[3:]])
        if name in ("and", "or") and len(arguments) == 2:
            return self.connected(name, arguments)
        return self.call_values(name, [self.value(part) for part in arguments])

    def connected(self, name, arguments):
        decisive, values, unknown = name == "or", [], None
        for argument in arguments:
            try:
                value = self.value(argument)
            except Unknown as why:
                unknown = unknown or why
                continue
            if terms.free_in(value) or value[0] == "opaque":
                unknown = unknown or Unknown("an open condition")
            elif truth(value) == decisive:
                return boolean(decisive)
            values.append(value)
        if unknown and len(values) == 2 and any(map(terms.free_in, values)):
            return terms.apply(("name", name), values)
        if unknown:
            raise unknown
        return boolean(not decisive)

    def call_values(self, name, values):
        arity = ARITY.get(name)
        if arity is None:
            return self.without_rule(name, values)
        if name in COMPUTES_NOTHING or len(values) < arity or any(terms.free_in(part) for part in values[:arity]):
            return terms.apply(("name", name), values)
        result = self.computed(name, values[:arity])
        return self.applied(result, values[arity:]) if values[arity:] else result

    def without_rule(self, name, values):
        if not self.inert(name):
            raise Unknown(f"{name} (the lexicon)")
        return terms.apply(("name", name), values)

    def computed(self, name, values):
        if name in ("=", "!="):
            return boolean(self.equal(*values) == (name == "="))
        if name == "not":
            return boolean(not truth(self.known(values[0])))
        if NULL in values:
            return NULL
        if any(value[0] == "opaque" for value in values):
            raise Unknown(next(value[1] for value in values if value[0] == "opaque"))
        if name in WORLD:
            raise Unknown(f"{name} (the world)")
        own = getattr(self, "do_" + name, None)
        if own:
            return own(*values)
        for table, kinds, give in ((NUMBERS, ("num",), lambda v: v[1]), (PLACES, ("point", "box"), lambda v: v),
                                   (LISTS, ("list",), lambda v: v[1]), (TEXTS, ("text",), lambda v: v[1])):
            if name in table:
                return table[name](*map(give, values)) if all(v[0] in kinds for v in values) else NULL
        raise Unknown(f"{name} (not written)")

    @staticmethod
    def known_at_all(value):
        if value[0] == "opaque or null":
            raise Unknown(value[1])
        return value

    @staticmethod
    def known(value):
        if value[0] == "opaque":
            raise Unknown(value[1])
        return value

    @staticmethod
    def equal(a, b):
        for one, other in ((a, b), (b, a)):
            if one[0] == "opaque":
                if other == NULL:
                    return False
                raise Unknown(one[1])
        return a == b

    # Lists

    def do_nth(self, a, n):
        fits = a[0] == "list" and n[0] == "num" and n[1] == int(n[1]) and 0 <= n[1] < len(a[1])
        return a[1][int(n[1])] if fits else NULL

    def do_take(self, a, n):
        return ("list", a[1][:max(0, int(n[1]))]) if a[0] == "list" and n[0] == "num" else NULL

    def do_append(self, a, b):
        return ("list", a[1] + b[1]) if a[0] == b[0] == "list" else NULL

    def do_concat(self, a):
        if a[0] != "list" or NULL in a[1]:
            raise Unknown("concat of a null")
        return ("list", sum((part[1] for part in a[1]), ()))

    def do_map(self, a, f):
        return ("list", tuple(self.applied(f, [part]) for part in a[1])) if a[0] == "list" else NULL

    def do_filter(self, a, f):
        if a[0] != "list":
            return NULL
        return ("list", tuple(part for part in a[1] if truth(self.known(self.applied(f, [part])))))

    def do_some(self, a, f):
        return self.quantified(a, f, True)

    def do_every(self, a, f):
        return self.quantified(a, f, False)

    def quantified(self, a, f, decisive):
        if a[0] != "list":
            return NULL
        unknown = None
        for part in a[1]:
            try:
                if truth(self.known(self.applied(f, [part]))) == decisive:
                    return boolean(decisive)
            except Unknown as why:
                unknown = why
        if unknown:
            raise unknown
        return boolean(not decisive)

    def do_sort_by(self, a, f):
        if a[0] != "list":
            return NULL
        keyed = [(self.applied(f, [part]), part) for part in a[1]]
        return ("list", tuple(part for _, part in sorted(
            keyed, key=lambda pair: pair[0][1] if pair[0][0] == "num" else math.inf)))

    def do_contains(self, a, b):
        return boolean(any(self.equal(part, b) for part in a[1])) if a[0] == "list" else NULL

    # Terms

    def typed(self, term, tell):
        try:
            return tell(types.infer(term, self.name_type))
        except types.UnknownType as why:
            raise Unknown(f"the type of {why}") from why
        except types.NoType as why:
            raise Unknown("types that do not go together") from why

    def type_text(self, term):
        return self.typed(term, types.type_text)

    def outer_type(self, term):
        return self.typed(term, types.found)

    def do_type(self, term):
        return ("text", self.type_text(term))

    def is_open(self, term):
        if term[0] == "lam":
            return True
        type_ = self.outer_type(term)
        if isinstance(type_, types.Variable):
            raise Unknown("an undetermined type")
        return isinstance(type_, tuple) and type_[0] == "->"

    def do_open(self, term):
        return boolean(self.is_open(term))

    def do_missing(self, term):
        if not self.is_open(term):
            return NULL
        try:
            return ("text", types.type_text(self.outer_type(term)[1]))
        except types.UnknownType as why:
            raise Unknown("the type of a variable") from why

    def do_fill(self, term, argument):
        if not self.is_open(term):
            return term
        result = self.applied(term, [self.fitting(argument, types.found(self.outer_type(term)[1]))])
        self.fills.append(result)
        return result

    def fitting(self, argument, wanted):
        """The argument, raised if need be."""
        own = self.outer_type(argument)
        try:
            types.unify(own, wanted)
            return argument
        except types.NoType:
            pass
        for rule in self.raising:
            try:
                types.unify(types.read_type(rule["from"]), own)
                types.unify(types.read_type(rule["to"]), wanted)
            except types.NoType:
                continue
            if "when" in rule and not truth(self.applied(self.value(terms.read(rule["when"])), [argument])):
                continue
            return self.raised_by(rule, argument)
        return NULL

    def raised_by(self, rule, argument):
        by = terms.read(rule["by"])
        return self.applied(self.value(by) if by[0] == "lam" else by, [argument])

    def do_lacking(self, term, part):
        found = terms.abstracted(term, part, terms.Hint("x", self.type_text(part)))
        if found is None:
            raise Unknown("lacking() of what does not occur")
        return found

    def do_program(self, term):
        head = head_of(term)
        return ("text", head[1]) if head[0] == "name" else NULL

    def do_argument(self, term, at):
        return argument_of(term, at[1]) if at[0] == "num" else NULL

    def do_mentions(self, term, text):
        if text[0] != "text":
            return NULL
        return boolean(text[1] in (term[1] if term[0] == "text" else terms.text_of(term)))

    def do_text(self, term):
        return term if term[0] == "text" else ("text", terms.text_of(term))

    @staticmethod
    def half(pointing, which):
        """A half of dot(things, place)."""
        made = pointing[0] == "app" and pointing[1] == ("name", "dot") and len(pointing[2]) == 2
        return pointing[2][which] if made else NULL

    def do_things_of(self, pointing):
        return self.half(pointing, 0)

    def do_place_of(self, pointing):
        return self.half(pointing, 1)

    def do_place(self, term):
        return first_place(term)

    def do_join(self, a, between):
        if a[0] != "list" or between[0] != "text" or any(part[0] != "text" for part in a[1]):
            raise Unknown("join of other things than texts")
        return ("text", between[1].join(part[1] for part in a[1]))

    # Places

    def do_square(self, place, side):
        if place[0] not in ("point", "box") or side[0] != "num":
            return NULL
        x, y, z = center(place)
        half = side[1] / 2
        return place_of((x - half, y - half, z), (x + half, y + half, z))

    def do_grow(self, place, by):
        return grown(place, by[1]) if place[0] in ("point", "box") and by[0] == "num" else NULL

    def do_toward(self, a, b, by):
        fits = a[0] in ("point", "box") and b[0] in ("point", "box") and by[0] == "num"
        return toward(a, b, by[1]) if fits else NULL
