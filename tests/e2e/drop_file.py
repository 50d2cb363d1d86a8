#!/usr/bin/env python3
"""Drops files on a window as a file manager does, by the XDND protocol: drop_file.py WINDOW FILE ..."""
import ctypes
import ctypes.util
import os
import pathlib
import sys
import time

x11 = ctypes.CDLL(ctypes.util.find_library("X11") or "libX11.so.6")
Long, Id, Pointer = ctypes.c_long, ctypes.c_ulong, ctypes.c_void_p
CLIENT_MESSAGE, SELECTION_REQUEST, SELECTION_NOTIFY = 33, 30, 31
XDND_VERSION = 5


class Message(ctypes.Structure):  # XClientMessageEvent
    _fields_ = [("type", ctypes.c_int), ("serial", Id), ("send_event", ctypes.c_int), ("display", Pointer), ("window", Id),
                ("kind", Id), ("format", ctypes.c_int), ("data", Long * 5)]


class Request(ctypes.Structure):  # XSelectionRequestEvent
    _fields_ = [("type", ctypes.c_int), ("serial", Id), ("send_event", ctypes.c_int), ("display", Pointer), ("owner", Id),
                ("requestor", Id), ("selection", Id), ("target", Id), ("property", Id), ("time", Id)]


class Notice(ctypes.Structure):  # XSelectionEvent
    _fields_ = [("type", ctypes.c_int), ("serial", Id), ("send_event", ctypes.c_int), ("display", Pointer), ("requestor", Id),
                ("selection", Id), ("target", Id), ("property", Id), ("time", Id)]


class Event(ctypes.Union):
    _fields_ = [("type", ctypes.c_int), ("message", Message), ("request", Request), ("notice", Notice), ("room", Long * 24)]


for name, result, arguments in (
        ("XOpenDisplay", Pointer, [ctypes.c_char_p]), ("XDefaultRootWindow", Id, [Pointer]), ("XPending", ctypes.c_int, [Pointer]),
        ("XInternAtom", Id, [Pointer, ctypes.c_char_p, ctypes.c_int]), ("XNextEvent", ctypes.c_int, [Pointer, Pointer]),
        ("XCreateSimpleWindow", Id, [Pointer, Id] + [ctypes.c_int] * 2 + [ctypes.c_uint] * 3 + [Id] * 2),
        ("XSetSelectionOwner", ctypes.c_int, [Pointer, Id, Id, Id]), ("XFlush", ctypes.c_int, [Pointer]),
        ("XSendEvent", ctypes.c_int, [Pointer, Id, ctypes.c_int, Long, Pointer]),
        ("XChangeProperty", ctypes.c_int, [Pointer, Id, Id, Id, ctypes.c_int, ctypes.c_int, ctypes.c_char_p, ctypes.c_int])):
    function = getattr(x11, name)
    function.restype, function.argtypes = result, arguments


class Source:
    """A window nobody sees, that files are dragged out of."""

    def __init__(self, target, files):
        self.display = x11.XOpenDisplay(None)
        assert self.display, "no display: " + os.environ.get("DISPLAY", "")
        self.target, self.uris = target, "".join(pathlib.Path(file).resolve().as_uri() + "\r\n" for file in files).encode()
        self.window = x11.XCreateSimpleWindow(self.display, x11.XDefaultRootWindow(self.display), 0, 0, 1, 1, 0, 0, 0)
        x11.XSetSelectionOwner(self.display, self.atom("XdndSelection"), self.window, 0)

    def atom(self, name):
        return x11.XInternAtom(self.display, name.encode(), 0)

    def send(self, kind, *data):
        event = Event(message=Message(type=CLIENT_MESSAGE, display=self.display, window=self.target, kind=self.atom(kind), format=32,
                                      data=(Long * 5)(self.window, *data)))
        x11.XSendEvent(self.display, self.target, 0, 0, ctypes.byref(event))
        x11.XFlush(self.display)

    def wait_for(self, kind, limit_s=60):
        """The target's message of that kind; what it asks for meanwhile is handed over."""
        deadline, event = time.monotonic() + limit_s, Event()
        while time.monotonic() < deadline:
            if not x11.XPending(self.display):
                time.sleep(0.01)
                continue
            x11.XNextEvent(self.display, ctypes.byref(event))
            if event.type == SELECTION_REQUEST:
                self.hand_over(event.request)
            elif event.type == CLIENT_MESSAGE and event.message.kind == self.atom(kind):
                return event.message.data
        raise AssertionError(f"no {kind} within {limit_s} s")

    def hand_over(self, asked):
        x11.XChangeProperty(self.display, asked.requestor, asked.property, asked.target, 8, 0, self.uris, len(self.uris))
        event = Event(notice=Notice(type=SELECTION_NOTIFY, display=self.display, requestor=asked.requestor, selection=asked.selection,
                                    target=asked.target, property=asked.property, time=asked.time))
        x11.XSendEvent(self.display, asked.requestor, 0, 0, ctypes.byref(event))
        x11.XFlush(self.display)

    def drop(self, x_px, y_px):
        self.send("XdndEnter", XDND_VERSION << 24, self.atom("text/uri-list"), 0, 0)
        self.send("XdndPosition", 0, x_px << 16 | y_px, 0, self.atom("XdndActionCopy"))
        assert self.wait_for("XdndStatus")[1] & 1, "the window takes nothing"
        self.send("XdndDrop", 0, 0, 0, 0)
        self.wait_for("XdndFinished")


Source(int(sys.argv[1], 0), sys.argv[2:]).drop(100, 100)
