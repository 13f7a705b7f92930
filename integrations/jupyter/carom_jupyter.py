"""Scenes of carom in Jupyter notebooks: README.md says how to use it.

All is made by the program `carom`, or by the one that the environment variable CAROM names.
"""

import base64
import csv
import hashlib
import html
import io
import json
import os
import re
import shlex
import subprocess

#: What scenes may take: "classroom", a film of at most 2 minutes and 20,000 particles; None: carom's own limits.
limits = "classroom"

#: Films of fewer bytes stand in the notebook itself, others in the folder carom-media beside it.
embed_below = 1_000_000

_FOLDER = "carom-media"


class CaromError(Exception):
    """What carom said of a scene that it could not show."""

    def _render_traceback_(self):
        return [str(self)]


def _call(arguments, text=None):
    """What carom writes to standard output; no shell is involved."""
    program = os.environ.get("CAROM", "carom")
    try:
        done = subprocess.run([program, *arguments], input=None if text is None else text.encode(),
                              stdin=subprocess.DEVNULL if text is None else None, capture_output=True, check=False)
    except OSError as error:
        raise CaromError(f"the program `{program}` cannot be run: {error.strerror}; install carom, or name it in the "
                         "environment variable CAROM") from None
    if done.returncode != 0:
        raise CaromError(done.stderr.decode(errors="replace").strip())
    return done.stdout.decode()


def _sets(values):
    """The options for values like {"gas.0.count": 50}; JSON is YAML."""
    options = []
    for key, value in values.items():
        if not re.fullmatch(r"[A-Za-z0-9_][A-Za-z0-9_ .\-]*", key):
            raise CaromError(f"`{key}` is no path of a key, as gas.0.count")
        options += ["--set", f"{key}={json.dumps(value)}"]
    return options


class _Scene:
    """A scene in a file, or as text, with values laid over it. Checks it; throws CaromError."""

    def __init__(self, path, text, values):
        self._scene = "-" if text is not None else os.path.join(".", os.fspath(path))
        self._text = text
        self._options = _sets(values) + (["--limits", limits] if limits else [])
        try:
            self.facts = json.loads(self._call("check", "--json"))[0]
        except CaromError:
            self._call("check", "--quiet")  # whose messages are for people
            raise

    def _call(self, command, *arguments):
        return _call([command, self._scene, *arguments, *self._options], self._text)

    def _path(self, *parts):
        """Where something is kept that is made of this scene and `parts`, without its ending."""
        key = hashlib.sha256(json.dumps([self.facts["made_from"], *parts]).encode()).hexdigest()[:16]
        return f"{_FOLDER}/{key}"

    def _picture(self, at, ending):
        at = 0.3 * self.facts["time"] if at is None else float(at)
        path = self._path("still", at) + "." + ending
        if not os.path.exists(path):
            self._call("still", "--quiet", "--at", f"{at:.6g}", "-o", path)
        return path

    def _words(self):
        return self.facts["description"]


class Still(_Scene):
    """A frame of a film as a picture, shown where a notebook shows its value."""

    def __init__(self, path=None, at=None, text=None, **values):
        super().__init__(path, text, values)
        self.svg = self._picture(at, "svg")
        self.png = self._picture(at, "png")

    def _repr_mimebundle_(self, include=None, exclude=None):
        # An <img>, which takes an alternative text and keeps the picture apart from the page.
        picture = f'<img src="data:image/svg+xml;base64,{_base64(self.svg)}" alt="{html.escape(self._words())}">'
        return {"text/html": picture, "image/png": _base64(self.png), "text/plain": self._words()}


class Film(_Scene):
    """A film with its captions and its transcript, shown where a notebook shows its value."""

    def __init__(self, path=None, at=None, text=None, **values):
        super().__init__(path, text, values)
        base = self._path("film")
        self.path = base + ".mp4"
        if not os.path.exists(self.path):
            self._call("render", "--quiet", "--words", "-o", self.path)
        self.tracks = {kind: f"{base}.{kind}.vtt" for kind in ("captions", "chapters", "descriptions")
                       if os.path.exists(f"{base}.{kind}.vtt")}
        self.transcript = _read(base + ".transcript.txt").decode()
        self.poster = self._picture(at, "png")

    def _address(self, path, kind):
        if os.path.getsize(self.path) >= embed_below:
            return path
        return f"data:{kind};base64,{_base64(path)}"

    def _repr_html_(self):
        tracks = "".join(
            f'<track kind="{kind}" src="{self._address(path, "text/vtt")}" srclang="{self.facts["language"]}" label="{kind}"'
            f'{" default" if kind == "captions" else ""}>' for kind, path in self.tracks.items())
        return (f'<video controls playsinline preload="metadata" style="max-width:100%" '
                f'poster="{self._address(self.poster, "image/png")}" aria-label="{html.escape(self._words())}">'
                f'<source src="{self._address(self.path, "video/mp4")}" type="video/mp4">{tracks}</video>'
                f'<details><summary>Transcript of the film</summary><pre style="white-space:pre-wrap">'
                f'{html.escape(self.transcript)}</pre></details>')

    def _repr_mimebundle_(self, include=None, exclude=None):
        return {"text/html": self._repr_html_(), "image/png": _base64(self.poster), "text/plain": self._words()}


class Run(_Scene):
    """What `carom run` measures. `summary` is its JSON document, `numbers` the single numbers in it by their paths."""

    def __init__(self, path=None, text=None, **values):
        super().__init__(path, text, values)
        self.summary = json.loads(self._call("run", "--json", "-"))
        self.numbers = dict(_numbers(self.summary))

    def frame(self):
        """The numbers as a pandas.DataFrame of one row."""
        import pandas
        return pandas.DataFrame([self.numbers])

    def samples(self):
        """Every sample, a row for each particle: a pandas.DataFrame, or without pandas a list of dictionaries."""
        table = io.StringIO(self._call("run", "--quiet", "--csv", "-"))
        try:
            import pandas
        except ImportError:
            return list(csv.DictReader(table))
        return pandas.read_csv(table)

    def _repr_html_(self):
        try:
            import pandas
            return pandas.Series(self.numbers, dtype=object).to_frame().to_html(header=False)
        except ImportError:
            rows = "".join(f"<tr><th>{html.escape(name)}</th><td>{number}</td></tr>" for name, number in self.numbers.items())
            return f"<table>{rows}</table>"

    def _repr_mimebundle_(self, include=None, exclude=None):
        lines = "\n".join(f"{name:40} {number}" for name, number in self.numbers.items())
        return {"text/html": self._repr_html_(), "text/plain": lines}


film, still, run = Film, Still, Run


def _read(path):
    with open(path, "rb") as file:
        return file.read()


def _base64(path):
    return base64.b64encode(_read(path)).decode()


def _numbers(value, name=""):
    """The numbers in a JSON document, but for those of histograms, which are many."""
    if isinstance(value, dict):
        for key, inner in value.items():
            if key not in ("histograms", "seconds"):
                yield from _numbers(inner, f"{name}.{key}" if name else key)
    elif isinstance(value, list):
        for place, inner in enumerate(value):
            label = inner.get("name", place) if isinstance(inner, dict) else place
            yield from _numbers(inner, f"{name}.{label}")
    elif isinstance(value, (int, float)) and not isinstance(value, bool):
        yield name, value


def _magic(line, cell):
    """%%carom [--film] [--run] [--at T]: shows the scene that the cell holds."""
    words = shlex.split(line)
    shows, at = Still, {}
    while words:
        word = words.pop(0)
        if word == "--film":
            shows = Film
        elif word == "--run":
            shows = Run
        elif word == "--at" and words:
            try:
                at = {"at": float(words[0])}
            except ValueError:
                raise CaromError(f"--at {words[0]}: expected a simulated time") from None
            words.pop(0)
        else:
            raise CaromError(f"%%carom has no option {word}; it has --film, --run and --at T")
    if shows is Run and at:
        raise CaromError("--at is for pictures; a run has no moment")
    return shows(text=cell, **at)


def load_ipython_extension(ipython):
    """%load_ext carom_jupyter"""
    ipython.register_magic_function(_magic, "cell", "carom")
