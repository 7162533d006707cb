"""The exception of the package."""


class Error(Exception):
    """Something cannot be used: a file, a record, an event. Says where, the thing found and the thing expected."""


Error.__module__ = "continua"  # by which it is known
