"""One source, two ways to run it: plain NumPy, or compiled by Numba with everything inlined.

A *template* is a module-level function that names what it needs (``pressure``, ``shear_stress``) as
globals set to :func:`unbound`. :func:`bind` fills them in with the functions of particular laws. The
plain result works on arrays at once and needs no compiler; the compiled one works on single numbers and
is cached on disk, under a name made of the bytecode of all that went into it, so that an edited law
never meets a stale cache.
"""

from __future__ import annotations

import dis
import functools
import hashlib
from collections.abc import Callable
from types import CodeType, FunctionType
from typing import Any

from drawbar.elementwise import TWINS

__all__ = ["bind", "unbound"]


def unbound(*_: Any) -> Any:
    """What a template's names stand for until :func:`bind` fills them in."""
    raise TypeError("this is a template: call drawbar.contact.bind.bind on it first.")


def bind(template: Any, *, compiled: bool = False, **bindings: Callable[..., Any]) -> Any:
    """``template`` with the functions it names filled in; the same object for the same request.

    Parameters
    ----------
    template
        A module-level function without closure.
    compiled
        Compile it, and every plain function that it or its bindings call, with Numba.
    bindings
        The functions, by the global name that the template uses; those bound before may be given.
    """
    return _bind(template, tuple(sorted(bindings.items())), compiled)


@functools.cache
def _bind(template: FunctionType, bindings: tuple[tuple[str, Any], ...], compiled: bool) -> Any:
    filled = _copy(template, {name: getattr(f, "py_func", f) for name, f in bindings}, template.__name__)
    return _compile(filled) if compiled else filled


@functools.cache
def _compile(function: FunctionType) -> Any:
    """The compiled function: its plain callees compiled first, then itself under a name of its content."""
    import numba  # late: it takes a tenth of a second, and plain runs never need it

    function = TWINS.get(function, function)
    callees = {name: _compile(called) for name, called in _callees(function).items()}
    named = _copy(function, callees, f"{function.__name__}_{_digest(function)}")
    try:
        return numba.njit(named, cache=True)
    except RuntimeError:  # a law typed at a prompt has no file to keep a cache beside
        return numba.njit(named)


def _copy(function: FunctionType, filled: dict[str, Any], name: str) -> FunctionType:
    copy = FunctionType(function.__code__, {**function.__globals__, **filled}, name, function.__defaults__)
    copy.__qualname__ = name  # Numba names its cache files after it
    copy.__module__ = function.__module__
    return copy


def _callees(function: FunctionType) -> dict[str, FunctionType]:
    """The plain Python functions that a function calls by a global name."""
    loads = (i.argval for i in dis.get_instructions(function.__code__) if i.opname == "LOAD_GLOBAL")
    named = {name: function.__globals__.get(name) for name in loads}
    named = {name: getattr(f, "py_func", f) for name, f in named.items()}  # also those compiled before
    return {name: f for name, f in named.items() if isinstance(f, FunctionType)}


def _digest(function: FunctionType) -> str:
    """A short name for a computation: the bytecode and constants of a function and of all it calls."""
    sha = hashlib.sha256()
    code = function.__code__
    constants = [c for c in code.co_consts if not isinstance(c, CodeType)]
    sha.update(repr((code.co_code, constants, code.co_names)).encode())
    for name, called in sorted(_callees(function).items()):
        sha.update((name + _digest(called)).encode())
    return sha.hexdigest()[:16]
