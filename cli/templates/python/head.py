import ctypes
import enum
import operator
import pathlib

import numpy


class Fault(Exception):
    """An entry point met a fault: the name of the status that it returned."""


class OutOfRange(OverflowError, ValueError):
    """A number is outside of its type or of the range that its author set."""


class _Enum(enum.IntEnum):
    def __repr__(self):
        return f"{type(self).__name__}.{self.name}"


class _Named:
    """A struct or a union of the C: a name that it has not, and a value that a field does not take, are refused."""

    _shown, _checks, _watched = (), {}, ()

    def __setattr__(self, name, value):
        if name not in self._shown:
            raise AttributeError(f"`{type(self).__name__}` has no field `{name}`; it has {', '.join(self._shown)}")
        check = self._checks.get(name)
        super().__setattr__(name, value if check is None else check(value))

    def __repr__(self):
        if isinstance(self, ctypes.Union):
            return "..."
        values = (f"{name}={_plain(getattr(self, name))!r}" for name in self._shown)
        return f"{type(self).__name__}({', '.join(values)})"


class _Struct(_Named, ctypes.Structure):
    def _valid(self):
        """Refuses elements of arrays that were set through a view and are outside of their range."""
        for name in self._watched:
            value = getattr(self, name)
            for part in value if isinstance(value, ctypes.Array) else [value]:
                if isinstance(part, _Struct):
                    part._valid()
                else:
                    self._checks[name](value)


class _Union(_Named, ctypes.Union):
    pass


def _plain(value):
    if isinstance(value, numpy.ndarray):
        return value.tolist()
    return [_plain(it) for it in value] if isinstance(value, ctypes.Array) else value


def _passed(value):
    """A struct, by its address."""
    if isinstance(value, _Struct):
        value._valid()
    return ctypes.byref(value)


def _within(name, values, kind, low, high):
    """Numbers in the range that their author set; NaN is in none."""
    numbers = numpy.asarray(values, dtype=kind)
    if not ((numbers >= low) & (numbers <= high)).all():
        raise OutOfRange(f"`{name}` is from {low} to {high}, not {_plain(numbers) if numbers.ndim else values}")
    return values


def _integers(name, values, least, most):
    for number in numpy.asarray(values, dtype=object).ravel():
        _integer(name, number, least, most)
    return values


def _flag(name, value):
    if value not in (0, 1):
        raise OutOfRange(f"`{name}` is True or False, not {value}")
    return bool(value)


def _items(name, values, kind):
    for number in numpy.asarray(values).ravel():
        kind(number)
    return values


def _array(name, values, kind, shape, order, written=False):
    """The elements in the order that the C has them in: the caller's own memory, if that is in this order already."""
    array = numpy.asarray(values, dtype=kind)
    if shape is not None and array.shape != shape:
        raise ValueError(f"`{name}` is an array of the shape {shape}, not {array.shape}")
    elements = array.ravel(order=order)
    if written and not numpy.shares_memory(elements, values):
        raise ValueError(f"`{name}` is written: give an array of {kind}, in the order {order!r} of NumPy's")
    return elements


def _integer(name, value, least, most):
    """A number that the C can hold: ctypes would cut one that it cannot."""
    number = operator.index(value)
    if not least <= number <= most:
        raise OutOfRange(f"`{name}` is from {least} to {most}, not {number}")
    return number


def _view(memory, shape, order):
    """A view of NumPy's on memory of a struct."""
    return numpy.ctypeslib.as_array(memory).reshape(shape, order=order)


def _check(status, kind):
    if status != 0:
        raise Fault(kind(status).name)
