"""Room for the frames of deep calls.

Python takes frames from pieces of 16 KB. A loop whose calls cross the end of a piece has the next one mapped and
unmapped at each turn: two thirds of the time of a derivation. A frame that fits into no such piece gets a larger one,
a power of two, whose rest is for the calls that it makes.
"""


def with_room(call):
    """The result of call()."""
    return call()


# Needs 320 KB, so it gets 512.
with_room.__code__ = with_room.__code__.replace(co_stacksize=40_000)
