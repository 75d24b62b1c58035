"""Vehicle crashes from Python: EES, delta-v, pulses and deformation by libcrumple.

    import crumple
    result = crumple.solve("scene.json", set={"A.speed_kmh": 60})
    result["A.ees_kmh"], result["A.cdc"], result.series("A.ax_mps2")
    table = crumple.solve_many(scenes, jobs=4, values=["A.ees_kmh", "B.delta_v_kmh"])

Standard library only (ctypes). Series and fields are arrays of numpy where it is installed, else
array.array and lists of lists; tables become frames of pandas with Table.frame().
The names of values are those of the result JSON, see libcrumple(3) and Result.names().
"""

from __future__ import annotations

import array
import ctypes
import html
import json
import os
import signal
import threading
import weakref
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any, Union

try:
    import numpy
except ImportError:
    numpy = None

__all__ = ["Crumple", "Error", "Result", "Table", "damage", "import_file", "solve"]
__all__ += ["solve_many", "version"]

Scene = Union[str, bytes, Mapping, os.PathLike]

_FIELDS = ("material", "damage", "energy", "absorbed", "ees", "time")
_TRACE, _RESOLVED, _PRETTY = 1, 2, 4
_INTERRUPTED = 16


class Error(Exception):
    """What went wrong: code ("unknown-key"), text, where (JSON pointer), line, column, hint."""

    def __init__(self, error: _Error, code: str) -> None:
        self.code = code
        self.source, self.where, self.text, self.hint = (
            field.decode("utf-8", "replace")
            for field in (error.source, error.where, error.text, error.hint)
        )
        self.line, self.column = error.line, error.column
        super().__init__(str(self))

    def __str__(self) -> str:
        place = f"{self.source}:{self.line}:{self.column}: " if self.line else ""
        if self.source and not self.line:
            place = self.source + ": "
        where = self.where + ": " if self.where else ""
        return place + where + self.text + (f" ({self.hint})" if self.hint else "")


class _Error(ctypes.Structure):
    _fields_ = [
        ("size", ctypes.c_size_t),
        ("code", ctypes.c_int),
        ("line", ctypes.c_int),
        ("column", ctypes.c_int),
        ("source", ctypes.c_char * 256),
        ("where", ctypes.c_char * 128),
        ("text", ctypes.c_char * 256),
        ("hint", ctypes.c_char * 192),
    ]

    def __init__(self) -> None:
        super().__init__(ctypes.sizeof(type(self)))


_Cancel = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p)
_Next = ctypes.CFUNCTYPE(
    ctypes.c_int, ctypes.c_void_p, ctypes.POINTER(ctypes.c_char_p), ctypes.POINTER(ctypes.c_size_t)
)
_Done = ctypes.CFUNCTYPE(
    ctypes.c_int, ctypes.c_void_p, ctypes.c_size_t, ctypes.c_void_p, ctypes.POINTER(_Error)
)
_Case = ctypes.CFUNCTYPE(
    ctypes.c_int, ctypes.c_void_p, ctypes.c_char_p, ctypes.c_size_t, ctypes.POINTER(_Error)
)


class _Options(ctypes.Structure):
    _fields_ = [
        ("size", ctypes.c_size_t),
        ("name", ctypes.c_char_p),
        ("folder", ctypes.c_char_p),
        ("set", ctypes.POINTER(ctypes.c_char_p)),
        ("sets", ctypes.c_size_t),
        ("cancel", _Cancel),
        ("user", ctypes.c_void_p),
    ]


def _load() -> ctypes.CDLL:
    """The library: CRUMPLE_LIBRARY names a file, else the one the system finds."""
    path = os.environ.get("CRUMPLE_LIBRARY") or "libcrumple.so.0"
    lib = ctypes.CDLL(path)
    pointer, size, text = ctypes.c_void_p, ctypes.c_size_t, ctypes.c_char_p
    error = ctypes.POINTER(_Error)
    options = ctypes.POINTER(_Options)
    of_text = [pointer, text, size, options, ctypes.POINTER(pointer), error]
    signatures = {
        "version": (text, []),
        "error_word": (text, [ctypes.c_int]),
        "open": (ctypes.c_int, [text, ctypes.POINTER(pointer), error]),
        "close": (None, [pointer]),
        "data_hash": (text, [pointer]),
        "solve": (ctypes.c_int, of_text),
        "stack": (ctypes.c_int, [pointer, ctypes.c_int, options, _Next, _Done, pointer, error]),
        "damage": (ctypes.c_int, of_text),
        "import": (ctypes.c_int, [pointer, text, options, _Case, pointer, error]),
        "result_free": (None, [pointer]),
        "json": (pointer, [pointer, ctypes.c_uint, ctypes.POINTER(size)]),
        "free": (None, [pointer]),
        "svg": (pointer, [pointer, ctypes.c_double, ctypes.POINTER(size)]),
        "name": (text, [pointer, size]),
        "value": (ctypes.c_int, [pointer, text, ctypes.POINTER(ctypes.c_double)]),
        "word": (text, [pointer, text]),
        "series": (size, [pointer, text, pointer, size]),
        "field": (
            size,
            [
                pointer,
                text,
                ctypes.c_int,
                pointer,
                size,
                ctypes.POINTER(ctypes.c_int),
                ctypes.POINTER(ctypes.c_double),
            ],
        ),
    }
    for name, (result, arguments) in signatures.items():
        function = getattr(lib, "crumple_" + name)
        function.restype, function.argtypes = result, arguments
    return lib


_lib = _load()


def version() -> str:
    """Version of the library that was loaded."""
    return _lib.crumple_version().decode()


def _check(code: int, error: _Error) -> None:
    if code == _INTERRUPTED:
        raise KeyboardInterrupt
    if code:
        raise Error(error, _lib.crumple_error_word(code).decode())


def _text(scene: Scene) -> tuple[bytes, str, str]:
    """JSON text of a scene, its name in errors, and the folder of the files it names."""
    if isinstance(scene, Mapping):
        return json.dumps(scene, allow_nan=False).encode(), "scene", "."
    if isinstance(scene, bytes) or (isinstance(scene, str) and scene.lstrip()[:1] in "{["):
        return scene if isinstance(scene, bytes) else scene.encode(), "scene", "."
    path = os.fspath(scene)
    with open(path, "rb") as file:
        return file.read(), path, os.path.dirname(path) or "."


class _Call:
    """Options of one call, and what ended it: ^C, or an exception in a callback, which would be
    lost in the C between; keeps alive what the options point to.

    Python runs handlers of signals only while it runs itself, which is in the poll. An exception
    from there would be lost in the C around it, so for the time of the call ^C sets a mark."""

    def __init__(self, name: str, folder: str, values: Mapping[str, Any]) -> None:
        texts = [f"{key}={value}".encode() for key, value in values.items()]
        self.cancelled = False
        self.raised: BaseException | None = None  # in a callback
        self.options = _Options(
            ctypes.sizeof(_Options),
            os.fsencode(name),
            os.fsencode(folder),
            (ctypes.c_char_p * len(texts))(*texts),
            len(texts),
            _Cancel(lambda _user: int(self.cancelled)),
            None,
        )

    def __enter__(self) -> _Call:
        self.handler = signal.getsignal(signal.SIGINT)
        main = threading.current_thread() is threading.main_thread()
        self.catches = main and self.handler is signal.default_int_handler
        if self.catches:
            signal.signal(signal.SIGINT, self._interrupt)
        return self

    def __exit__(self, *_: Any) -> None:
        if self.catches:
            signal.signal(signal.SIGINT, self.handler)
        if self.cancelled:
            raise KeyboardInterrupt
        if self.raised is not None:
            raise self.raised

    def _interrupt(self, _signal: int, _frame: Any) -> None:
        self.cancelled = True


class Crumple:
    """Models and risk functions of a data folder, by default those of the installation."""

    def __init__(self, data_folder: str | None = None) -> None:
        error, pointer = _Error(), ctypes.c_void_p()
        folder = os.fsencode(data_folder) if data_folder is not None else None
        _check(_lib.crumple_open(folder, ctypes.byref(pointer), ctypes.byref(error)), error)
        self._pointer = pointer
        self._finalizer = weakref.finalize(self, _lib.crumple_close, pointer)

    @property
    def data_hash(self) -> str:
        """SHA-256 of all models and risk functions."""
        return _lib.crumple_data_hash(self._pointer).decode()

    def solve(self, scene: Scene, set: Mapping[str, Any] = {}) -> Result:
        """Solve a scene: a dict, JSON text, or the path of a file; set overrides values."""
        return Result(self._work(_lib.crumple_solve, scene, set))

    def damage(self, measured: Scene) -> dict[str, Any]:
        """EES and delta-v, with intervals, out of a measured deformation: a dict, JSON text or the
        path of a file as crumple damage reads it."""
        return json.loads(Result._take(self._work(_lib.crumple_damage, measured, {}).value))

    def _work(self, function: Any, scene: Scene, set: Mapping[str, Any]) -> ctypes.c_void_p:
        text, name, folder = _text(scene)
        call, pointer = _Call(name, folder, set), ctypes.c_void_p()
        of, to = ctypes.byref(call.options), ctypes.byref(pointer)
        self._run(call, function, text, len(text), of, to)
        return pointer

    def _run(self, call: _Call, function: Any, *arguments: Any) -> None:
        error = _Error()
        with call:
            code = function(self._pointer, *arguments, ctypes.byref(error))
        _check(code, error)

    def import_file(
        self, path: str | os.PathLike, **options: Any
    ) -> tuple[list[dict[str, Any]], list[Error]]:
        """Scenes out of another program's file or folder, and the errors of those cases that could
        not be converted. Options are those of crumple import: case="3,17", reference="cg"."""
        call = _Call("scene", ".", options)
        cases, of = _Cases(call), ctypes.byref(call.options)
        self._run(call, _lib.crumple_import, os.fsencode(path), of, _Case(cases.take), None)
        return cases.scenes, cases.errors

    def solve_many(
        self,
        scenes: Iterable[Scene],
        jobs: int = 0,
        values: Sequence[str] | None = None,
        set: Mapping[str, Any] = {},
    ) -> Table:
        """Solve scenes on so many threads (0: one per processor), whatever order they end in.

        Gives a table with a row per scene: the values named, or all that the first result has,
        and "error" with what was wrong with a scene, else None. Numbers and None; texts as str.
        """
        call = _Call("scene", ".", set)
        stack, of = _Stack(call, iter(scenes), values), ctypes.byref(call.options)
        self._run(call, _lib.crumple_stack, jobs, of, _Next(stack.next), _Done(stack.done), None)
        return stack.table()


def _told(error: Any) -> Error:
    """An error that a callback is given."""
    return Error(error[0], _lib.crumple_error_word(error[0].code).decode())


def _callback(stop: int) -> Any:
    """A method as a callback: an exception in it is kept for the end of the call and stops it."""

    def wrap(method: Any) -> Any:
        def guarded(self: Any, *arguments: Any) -> int:
            try:
                return method(self, *arguments)
            except BaseException as raised:
                self.call.raised = raised
                return stop

        return guarded

    return wrap


class _Cases:
    """What an import gives."""

    def __init__(self, call: _Call) -> None:
        self.call = call
        self.scenes: list[dict[str, Any]] = []
        self.errors: list[Error] = []

    @_callback(stop=1)
    def take(self, _user: Any, scene: bytes | None, _length: int, error: Any) -> int:
        if scene is None:
            self.errors.append(_told(error))
        else:
            self.scenes.append(json.loads(scene))
        return 0


class _Stack:
    """What a stack takes and gives."""

    def __init__(self, call: _Call, scenes: Iterator[Scene], values: Sequence[str] | None) -> None:
        self.call, self.scenes, self.values = call, scenes, values
        self.rows: list[tuple[dict, str | None]] = []
        self.text = b""

    @_callback(stop=0)
    def next(self, _user: Any, scene: Any, length: Any) -> int:
        try:
            self.text, name, folder = _text(next(self.scenes))
        except StopIteration:
            return 0
        self.call.options.name, self.call.options.folder = os.fsencode(name), os.fsencode(folder)
        scene[0], length[0] = self.text, len(self.text)
        return 1

    @_callback(stop=1)
    def done(self, _user: Any, _index: int, pointer: int | None, error: Any) -> int:
        if pointer is None:
            self.rows.append(({}, str(_told(error))))
            return 0
        result = Result(ctypes.c_void_p(pointer))
        if self.values is None:
            self.values = result.names()
        self.rows.append(({name: result.get(name) for name in self.values}, None))
        return 0

    def table(self) -> Table:
        names = self.values or []
        table = Table({name: [row.get(name) for row, _ in self.rows] for name in names})
        table["error"] = [error for _, error in self.rows]
        return table


class Table(dict):
    """Columns by name, each a list with a value per scene."""

    def frame(self) -> Any:
        """As a DataFrame of pandas."""
        import pandas

        return pandas.DataFrame(dict(self))

    def _repr_html_(self) -> str:
        head = "".join(f"<th>{html.escape(name)}</th>" for name in self)
        rows = (
            "".join(f"<td>{'' if v is None else html.escape(str(v))}</td>" for v in row)
            for row in zip(*self.values())
        )
        body = "".join(f"<tr>{row}</tr>" for row in rows)
        return f"<table><tr>{head}</tr>{body}</table>"


class Result:
    """A solved scene. Values by name with result["A.ees_kmh"], never changed once made."""

    def __init__(self, pointer: ctypes.c_void_p) -> None:
        self._pointer = pointer
        self._finalizer = weakref.finalize(self, _lib.crumple_result_free, pointer)

    def names(self) -> list[str]:
        """Names of all values."""
        names: list[str] = []
        while name := _lib.crumple_name(self._pointer, len(names)):
            names.append(name.decode())
        return names

    def __getitem__(self, name: str) -> float | str:
        number = ctypes.c_double()
        if _lib.crumple_value(self._pointer, name.encode(), ctypes.byref(number)) == 0:
            return number.value
        word = _lib.crumple_word(self._pointer, name.encode())
        if word is None:
            raise KeyError(name)
        return word.decode()

    def get(self, name: str, default: Any = None) -> Any:
        """The value of a name, or the default where there is none or it is not defined."""
        try:
            value = self[name]
        except KeyError:
            return default
        return default if value != value else value

    def series(self, name: str) -> Any:
        """A time series: "t_s", "A.ax_mps2" ... as in the trace of the result."""
        n = _lib.crumple_series(self._pointer, name.encode(), None, 0)
        if n == 0:
            raise KeyError(name)
        data = array.array("d", bytes(8 * n))
        _lib.crumple_series(self._pointer, name.encode(), data.buffer_info()[0], n)
        return data if numpy is None else numpy.frombuffer(data)

    def field(self, id: str, kind: str = "damage") -> Any:
        """Voxels of a participant as rows of y (to the left) of columns of x (forward).

        kind: material and damage (shares, 0 to 1), energy and absorbed (J), ees (km/h), time (s).
        """
        if kind not in _FIELDS:
            raise KeyError(f"{kind} is none of {', '.join(_FIELDS)}")
        n, dims, _ = self._field(id, kind, None, 0)
        if n == 0:
            raise KeyError(id)
        data = array.array("f", bytes(4 * n))
        self._field(id, kind, data.buffer_info()[0], n)
        nx, ny = dims[0], dims[1]
        if numpy is not None:
            return numpy.frombuffer(data, dtype=numpy.float32).reshape(ny, nx)
        return [data[y * nx : (y + 1) * nx].tolist() for y in range(ny)]

    def frame(self, id: str) -> dict[str, float]:
        """Where the voxels of a participant lie: corner of the first one and edge in the frame of
        the vehicle (m), and the place and heading of its centre of gravity after the contact."""
        n, _, frame = self._field(id, "damage", None, 0)
        if n == 0:
            raise KeyError(id)
        keys = ("x0_m", "y0_m", "edge_m", "x_m", "y_m", "heading_rad")
        return dict(zip(keys, frame))

    def _field(self, id: str, kind: str, out: Any, size: int) -> tuple[int, Any, Any]:
        dims, frame = (ctypes.c_int * 3)(), (ctypes.c_double * 6)()
        which = _FIELDS.index(kind)
        n = _lib.crumple_field(self._pointer, id.encode(), which, out, size, dims, frame)
        return n, dims, frame

    def json(self, trace: bool = False, resolved: bool = False, pretty: bool = False) -> str:
        """The result as crumple run prints it."""
        flags = _TRACE * trace | _RESOLVED * resolved | _PRETTY * pretty
        return self._take(_lib.crumple_json(self._pointer, flags, None))

    def dict(self, trace: bool = False, resolved: bool = False) -> dict[str, Any]:
        """The same as a dict."""
        return json.loads(self.json(trace, resolved))

    @staticmethod
    def _take(pointer: int | None) -> str:
        if pointer is None:
            raise MemoryError
        try:
            return ctypes.string_at(pointer).decode()
        finally:
            _lib.crumple_free(pointer)

    def svg(self, time: float | None = None) -> str:
        """The scene from above as SVG, at a time (s) or after the crash."""
        at = float("nan") if time is None else time
        return self._take(_lib.crumple_svg(self._pointer, at, None))

    def _repr_html_(self) -> str:
        return self.svg() + f"<p>{html.escape(repr(self)[1:-1])}</p>"

    def _vehicles(self) -> list[str]:
        return [part["id"] for part in self.dict()["participants"] if "ees_kmh" in part]

    def __repr__(self) -> str:
        parts = (
            f"{id}: EES {self[id + '.ees_kmh']:.1f} km/h, "
            f"delta-v {self[id + '.delta_v_kmh']:.1f} km/h"
            for id in self._vehicles()
        )
        return f"<crumple.Result {self['scene']}: {'; '.join(parts)}>"


_default: Crumple | None = None


def _handle() -> Crumple:
    global _default
    if _default is None:
        _default = Crumple()
    return _default


def solve(scene: Scene, set: Mapping[str, Any] = {}) -> Result:
    """Crumple.solve with the models of the installation."""
    return _handle().solve(scene, set)


def damage(measured: Scene) -> dict[str, Any]:
    """Crumple.damage with the models of the installation."""
    return _handle().damage(measured)


def import_file(
    path: str | os.PathLike, **options: Any
) -> tuple[list[dict[str, Any]], list[Error]]:
    """Crumple.import_file with the models of the installation."""
    return _handle().import_file(path, **options)


def solve_many(
    scenes: Iterable[Scene],
    jobs: int = 0,
    values: Sequence[str] | None = None,
    set: Mapping[str, Any] = {},
) -> Table:
    """Crumple.solve_many with the models of the installation."""
    return _handle().solve_many(scenes, jobs, values, set)
