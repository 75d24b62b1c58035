#!/usr/bin/env python3
"""A monkey at the full screen: random keys, mouse, sizes, pastes, signals; then every kind of end.

usage: monkey.py CRUMPLE SECONDS [SEED]
       monkey.py --recover CRUMPLE FAULT.so   killed at each step of load --recover

Each round starts the program on a terminal of its own, does what the generator says, and ends it in
another way. After each end must hold: it ends, with the status of that end; the modes of the
terminal's line are as before; the main screen, without mouse and paste reports, with the cursor;
the program took less than 400 MB. Prints what did not hold, with the seed of the round; status 1.
Works in the current folder, where scenes lie.
"""
import fcntl
import os
import random
import re
import select
import shutil
import signal
import struct
import sys
import termios
import time

COMMANDS = ["load pole.json", "load crash.json", "solve", "pulse", "table", "undo", "redo", "list",
            "move A dx=0.1", "vehicle C type=sedan mass=1200", "object W kind=wall", "check", "set",
            "place C facing A overlap=40%", "sweep A.speed 20:22:1", "set dt=1", "help solve",
            "save! x.json", "export! result y.json", "explain", "history", "view theme=dark",
            "apropos mass", "assert A.ees < 3", "\x01\x02", '"unterminated', "vehicle \u202eX",
            "remove C", "show time=end", "set end=rest", "load --recover", "nonsense", "view pulse"]
KEYS = ["\x1bOP", "\x1b[15~", "\x1b[17~", "\x1b[18~", "\x1b[19~", "\t", "\x1b", "\x1b[A", "\x1b[B",
        "\x1b[D", "\x1b[C", "\x1b[H", "\x1b[F", "\x1b[5~", "\x1b[6~", "\r", "\x7f", " ", "\x1b1",
        "\x1b2", "\x1b3", "\x1b4", "\x1b5", "\x1b6", "\x01", "\x05", "\x0b", "\x12", "\x0c", "\x17",
        "\x19", "?", "\x1b[3~", "\x1b[2~", "\x1b[1;5D", "\x1b[Z", "\x1bOQ", "\x1bOR", "\x1bOS",
        "\x1b[20~", "\x1b[23~", "\x1b[24~", "\x1b[", "\x1bO", "\x1b[<", "\x1b[200~"]
ENDS = {  # what ends it, and the statuses that may follow: an exit, or minus the signal
    "quit!": (0,), "F10": (0,), "^D": (0,), "TERM": (143, -15), "HUP": (129, -1),
    "SEGV": (139, 134, -11, -6), "ABRT": (134, -6), "KILL": (-9,), "hang-up": (129, -1, 0)}


class Terminal:
    """The program on a pseudo terminal whose other end stays open for us to look at."""

    def __init__(self, crumple, *words, **more):
        self.master, self.slave = os.openpty()
        self.size(100, 30)
        self.before = termios.tcgetattr(self.slave)
        self.told, self.most = b"", 0
        self.pid = os.fork()
        if self.pid == 0:
            os.setsid()
            fcntl.ioctl(self.slave, termios.TIOCSCTTY, 0)
            for fd in (0, 1, 2):
                os.dup2(self.slave, fd)
            os.closerange(3, 64)
            os.environ.update(TERM="xterm-256color", HOME=os.getcwd(), INPUTRC="/dev/null",
                              XDG_STATE_HOME=os.path.join(os.getcwd(), "state"))
            os.environ.update(more)
            os.execv(crumple, [crumple, *words])
        os.set_blocking(self.master, False)
        self.status = None

    def size(self, columns, lines):
        fcntl.ioctl(self.master, termios.TIOCSWINSZ, struct.pack("HHHH", lines, columns, 0, 0))

    def alive(self):
        if self.status is None:
            pid, status = os.waitpid(self.pid, os.WNOHANG)
            if pid != 0:
                self.status = os.waitstatus_to_exitcode(status)
        return self.status is None

    def listen(self, seconds):
        until = time.monotonic() + seconds
        while True:
            left = until - time.monotonic()
            ready, _, _ = select.select([self.master], [], [], max(left, 0))
            if not ready:
                return
            try:
                got = os.read(self.master, 65536)
            except (BlockingIOError, OSError):
                return
            if not got:
                return
            self.told = (self.told + got)[-200000:]

    def wait_for(self, text, seconds=15):
        until = time.monotonic() + seconds
        while self.alive() and text not in self.told and time.monotonic() < until:
            self.listen(0.02)

    def type(self, text):
        data = text if isinstance(text, bytes) else text.encode()
        until = time.monotonic() + 5
        while data and time.monotonic() < until and self.alive():
            try:
                data = data[os.write(self.master, data):]
            except BlockingIOError:
                self.listen(0.02)
        return not data

    def signal(self, number):
        if self.alive():
            os.kill(self.pid, number)

    def weigh(self):
        try:
            with open("/proc/%d/status" % self.pid) as told:
                found = re.search(r"VmRSS:\s*(\d+)", told.read())
                self.most = max(self.most, int(found.group(1)) if found else 0)
        except OSError:
            pass

    def ended(self, seconds):
        until = time.monotonic() + seconds
        while self.alive() and time.monotonic() < until:
            self.listen(0.02)
        self.listen(0.05)
        return not self.alive()

    def close(self):
        if self.alive():
            os.kill(self.pid, signal.SIGKILL)
            os.waitpid(self.pid, 0)
        for fd in (self.master, self.slave):
            if fd >= 0:
                os.close(fd)


def act(rnd, t):
    roll = rnd.random()
    if roll < 0.35:
        t.type(rnd.choice(KEYS))
    elif roll < 0.5:
        t.type(rnd.choice(COMMANDS) + "\r")
    elif roll < 0.68:
        t.type(rnd.choice("abcdrRuUzs<>+-?1234567890 /;=#\"\\"))
    elif roll < 0.83:
        t.type("\x1b[<%d;%d;%d%s" % (rnd.choice([0, 0, 1, 2, 32, 64, 65, 35]), rnd.randint(1, 220),
                                     rnd.randint(1, 70), rnd.choice("Mm")))
    elif roll < 0.9:
        t.size(rnd.choice([1, 5, 20, 40, 80, 100, 200, 300]), rnd.choice([1, 2, 5, 10, 24, 50, 90]))
    elif roll < 0.94:
        t.type(bytes(rnd.randrange(256) for _ in range(rnd.randint(1, 12))).replace(b"\x1a", b""))
    elif roll < 0.97:
        t.type("\x1b[200~%s\n\x1b[31m%s\x1b[201~" % (rnd.choice(COMMANDS), "x" * rnd.randint(0, 500)))
    else:
        t.signal(rnd.choice([signal.SIGWINCH, signal.SIGINT, signal.SIGCONT]))


def end_by(kind, t):
    """Ends it; a dialogue that is open, a search or a pasted line is given up before."""
    t.size(100, 30)
    if kind in ("quit!", "F10", "^D"):
        for _ in range(40):
            if not t.alive():
                return
            t.type("\x1b[201~\x03")
            t.listen(0.05)
            t.type("\x1b")
            t.listen(0.1)
            t.type({"quit!": "\x01\x0bquit!\r", "F10": "\x1b[21~", "^D": "\x01\x0b\x04"}[kind])
            t.listen(0.1)
            t.type("q")  # without saving, where it asks
            if t.ended(0.4):
                return
    elif kind == "hang-up":
        os.close(t.master)
        t.master = -1
        until = time.monotonic() + 15
        while t.alive() and time.monotonic() < until:
            time.sleep(0.02)
        return
    else:
        t.signal(getattr(signal, "SIG" + kind))
    t.ended(15)


def last(told, on, off):
    """Whether a mode was left off: the last of both that was written switches it off."""
    return told.rfind(on) <= told.rfind(off)


def wrong_after(kind, t):
    if t.alive():
        return "it does not end"
    if t.status not in ENDS[kind] and t.status != 0:
        return "status %d" % t.status
    if t.most > 400000:
        return "%d kB of memory" % t.most
    if kind in ("KILL", "hang-up"):  # nobody can tidy up, or nobody looks
        return None
    if termios.tcgetattr(t.slave) != t.before:
        return "the modes of the line are others than before"
    for name, on, off in (("the alternate screen", b"\x1b[?1049h", b"\x1b[?1049l"),
                          ("the mouse", b"\x1b[?1000h", b"\x1b[?1000l"),
                          ("motion of the mouse", b"\x1b[?1002h", b"\x1b[?1002l"),
                          ("marks of pastes", b"\x1b[?2004h", b"\x1b[?2004l"),
                          ("a hidden cursor", b"\x1b[?25l", b"\x1b[?25h")):
        if not last(t.told, on, off):
            return "%s is left on" % name
    return None


def round_of(crumple, seed, kind, seconds):
    rnd = random.Random("monkey %s" % seed)
    t = Terminal(crumple)
    t.wait_for(b"\x1b[?1049h")  # a ^C before that ends the program, as it should
    t.listen(0.3)
    until, acts = time.monotonic() + seconds, 0
    while time.monotonic() < until and t.alive():
        act(rnd, t)
        t.listen(rnd.choice([0, 0, 0.005, 0.02]))
        acts += 1
        if acts % 20 == 0:
            t.weigh()
    end_by(kind, t)
    wrong = wrong_after(kind, t)
    t.close()
    return acts, wrong


def prompted(crumple, state, lines, **more):
    """A plain prompt on a terminal, in which the lines are typed; the terminal, still open."""
    t = Terminal(crumple, "--repl", XDG_STATE_HOME=state, **more)
    t.wait_for(b"crumple> ")
    for line in lines:
        if not t.alive():
            break
        t.told = b""
        t.type(line + "\r")
        t.wait_for(b"crumple> ")
    return t


def recoverable(crumple, state):
    """Whether the scene of mass 1612 is still there for the next session."""
    t = prompted(crumple, state, ["load --recover", "vehicle A"])
    found = b"1612" in t.told
    t.close()
    return found


def recover(crumple, fault):
    left = os.path.join(os.getcwd(), "left")
    t = prompted(crumple, left, ["load pole.json", "vehicle A mass=1612kg"])
    t.signal(signal.SIGKILL)
    t.ended(10)
    t.close()
    wrong, kills = 0, 0
    for kind in ("open", "write", "sync", "link", "rename", "unlink"):
        for at in range(60):
            state = os.path.join(os.getcwd(), "again")
            shutil.rmtree(state, ignore_errors=True)
            shutil.copytree(left, state)
            t = prompted(crumple, state, ["load --recover"], LD_PRELOAD=fault, FAULT_KIND=kind,
                         FAULT_AT=str(at), FAULT_KILL="1")
            killed = t.ended(0)
            t.close()
            if not killed:
                break
            kills += 1
            if not recoverable(crumple, state):
                print("killed at %s %d: the scene is gone" % (kind, at))
                wrong += 1
    print("# killed %d times" % kills)
    return 1 if wrong > 0 or kills < 5 else 0


def main(crumple, seconds, seed=None):
    begun, k, acts, wrong = time.monotonic(), 0, 0, 0
    seed = int(seed) if seed is not None else random.randrange(10**9)
    each = max(0.4, seconds / 2 / len(ENDS))
    while k < len(ENDS) or time.monotonic() - begun < seconds:
        kind = list(ENDS)[k % len(ENDS)]
        done, why = round_of(crumple, seed + k, kind, each)
        acts += done
        if why is not None:
            print("seed %d, ended by %s: %s" % (seed + k, kind, why))
            wrong += 1
        k += 1
    print("# %d rounds from seed %d, %d acts" % (k, seed, acts))
    return 1 if wrong > 0 else 0


if __name__ == "__main__":
    if not 3 <= len(sys.argv) <= 4:
        sys.exit(__doc__)
    if sys.argv[1] == "--recover":
        sys.exit(recover(os.path.abspath(sys.argv[2]), sys.argv[3]))
    sys.exit(main(os.path.abspath(sys.argv[1]), float(sys.argv[2]), *sys.argv[3:]))
