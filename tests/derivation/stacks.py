"""Stacks by the rules of engine/automaton/FORMAT.md: whole lists are copied, slowly.

A symbol is a dictionary {slot: term} with all slots. A stack is a list of symbols, the bottom first.
"""
import math

from terms import NULL

# The log leaves a slot out where it is null or an empty list. In a slot of type `term` it can be either.
HIDDEN = ("opaque or null", "a slot of type term that the log leaves out")
EMPTY = (NULL, ("list", ()), HIDDEN)


class Unexpected(Exception):
    """The log's symbols cannot come from the operation."""


def near(a, b):
    """Equal terms, or places and numbers that differ by less than the log's six decimals show."""
    if isinstance(a, float) and isinstance(b, float):
        return math.isclose(a, b, rel_tol=0, abs_tol=2e-6)
    if isinstance(a, tuple) and isinstance(b, tuple):
        return len(a) == len(b) and all(map(near, a, b))
    return a == b


def without_empty(symbol):
    return {slot: value for slot, value in symbol.items() if value not in EMPTY}


def same(a, b):
    a, b = without_empty(a), without_empty(b)
    return a.keys() == b.keys() and all(near(a[slot], b[slot]) for slot in a)


def filled(inherited, content, logged, values, slots):
    """A new symbol: slots with a known value have it, slots with an unknown one have what the log says."""
    symbol = dict(inherited)
    for slot, written in content.items():
        if written is None:
            symbol[slot] = slots[slot]["empty"]
        else:
            hidden = slots[slot]["type"] == "term" and logged[slot] == NULL
            symbol[slot] = values.get(slot, HIDDEN if hidden else logged[slot])
    return symbol


def show_below(symbol, content, below):
    """`rewrite_below`: what is null shows the value below, except what is written as null."""
    for slot in symbol:
        if symbol[slot] == NULL and below and content.get(slot, "") is not None:
            symbol[slot] = below[slot]


def flushed(top, content, slots):
    content = content if isinstance(content, dict) else {}
    return {slot: value if slots[slot].get("persists") and slot not in content else slots[slot]["empty"]
            for slot, value in top.items()}


def popped_until(stack, history, state, slots):
    """Until the topmost symbol is as at the entry of the state before the present one."""
    wanted = next((top for entered, top in reversed(history[:-1]) if entered == state), None)
    if wanted is None:
        return [flushed(stack[-1], {}, slots)]
    stack = list(stack)
    while len(stack) > 1 and not same(stack[-1], wanted):
        stack.pop()
    return stack


def operated(stack, history, operation, logged, values, slots, rewrite_below):
    """The stack after an operation. `logged`: the new symbols as the log has them, the lowest first; `values`: for each
    the values of its contents that are known."""
    kind, content = next(iter(operation.items()))
    if kind == "none" or content is None:
        return list(stack)
    if kind == "pop":
        return stack[:max(1, len(stack) - content)]
    if kind == "flush":
        return [flushed(stack[-1], content, slots)]
    if kind == "pop_until":
        return popped_until(stack, history, content, slots)
    return added(stack, kind, content, logged, values, slots, rewrite_below)


def added(stack, kind, content, logged, values, slots, rewrite_below):
    base, inherited = list(stack), stack[-1]
    if kind.startswith("rewrite"):
        base.pop()
    if kind in ("push", "rewrite") and len(logged) != 1:
        raise Unexpected(f"{kind} makes one symbol, the log has {len(logged)}")
    for symbol, known in zip(logged, values):
        own = filled(inherited, content, symbol, known, slots)
        if kind.startswith("rewrite") and rewrite_below:
            show_below(own, content, base[-1] if base else None)
        base.append(own)
        inherited = own
    return base
