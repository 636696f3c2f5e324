#!/usr/bin/env python3
"""Drops a file onto an X11 window, as a file manager does (XDND version 5): drop_file.py WINDOW X Y PATH.

Through libX11 alone, which is there wherever the window is. Exits with 0 once the window says that it took the file.
"""
import ctypes
import pathlib
import sys
import time

CLIENT_MESSAGE, SELECTION_REQUEST, SELECTION_NOTIFY = 33, 30, 31
c_long, c_ulong, c_int, c_void_p = ctypes.c_long, ctypes.c_ulong, ctypes.c_int, ctypes.c_void_p

COMMON = [("type", c_int), ("serial", c_ulong), ("send_event", c_int), ("display", c_void_p)]


class ClientMessage(ctypes.Structure):
    _fields_ = COMMON + [("window", c_ulong), ("message_type", c_ulong), ("format", c_int), ("data", c_long * 5)]


class SelectionRequest(ctypes.Structure):
    _fields_ = COMMON + [("owner", c_ulong), ("requestor", c_ulong), ("selection", c_ulong), ("target", c_ulong),
                         ("property", c_ulong), ("time", c_ulong)]


class Selection(ctypes.Structure):
    _fields_ = COMMON + [("requestor", c_ulong), ("selection", c_ulong), ("target", c_ulong), ("property", c_ulong),
                         ("time", c_ulong)]


class Event(ctypes.Union):
    _fields_ = [("type", c_int), ("client", ClientMessage), ("request", SelectionRequest), ("selection", Selection),
                ("pad", c_long * 24)]


x11 = ctypes.CDLL("libX11.so.6")
x11.XOpenDisplay.restype = c_void_p
x11.XDefaultRootWindow.restype = x11.XCreateSimpleWindow.restype = x11.XInternAtom.restype = c_ulong
x11.XDefaultRootWindow.argtypes = x11.XPending.argtypes = x11.XFlush.argtypes = [c_void_p]
x11.XInternAtom.argtypes = [c_void_p, ctypes.c_char_p, c_int]
x11.XCreateSimpleWindow.argtypes = [c_void_p, c_ulong, c_int, c_int, c_int, c_int, c_int, c_ulong, c_ulong]
x11.XSetSelectionOwner.argtypes = [c_void_p, c_ulong, c_ulong, c_ulong]
x11.XSendEvent.argtypes = [c_void_p, c_ulong, c_int, c_long, ctypes.POINTER(Event)]
x11.XNextEvent.argtypes = [c_void_p, ctypes.POINTER(Event)]
x11.XChangeProperty.argtypes = [c_void_p, c_ulong, c_ulong, c_ulong, c_int, c_int, ctypes.c_char_p, c_int]


class Drag:
    def __init__(self, target, path):
        self.display = x11.XOpenDisplay(None)
        if not self.display:
            sys.exit("no display")
        root = x11.XDefaultRootWindow(self.display)
        self.source = x11.XCreateSimpleWindow(self.display, root, 0, 0, 1, 1, 0, 0, 0)
        self.target = target
        self.data = (pathlib.Path(path).absolute().as_uri() + "\r\n").encode()
        x11.XSetSelectionOwner(self.display, self.atom("XdndSelection"), self.source, 0)

    def atom(self, name):
        return x11.XInternAtom(self.display, name.encode(), 0)

    def send(self, name, *data):
        event = Event()
        event.client.type = CLIENT_MESSAGE
        event.client.window = self.target
        event.client.message_type = self.atom(name)
        event.client.format = 32
        for i, value in enumerate((self.source,) + data):
            event.client.data[i] = value
        x11.XSendEvent(self.display, self.target, 0, 0, ctypes.byref(event))
        x11.XFlush(self.display)

    def answer(self, request):
        """Hands over the file's name."""
        x11.XChangeProperty(self.display, request.requestor, request.property, request.target, 8, 0, self.data,
                            len(self.data))
        event = Event()
        event.selection.type = SELECTION_NOTIFY
        event.selection.requestor = request.requestor
        event.selection.selection = request.selection
        event.selection.target = request.target
        event.selection.property = request.property
        event.selection.time = request.time
        x11.XSendEvent(self.display, request.requestor, 0, 0, ctypes.byref(event))
        x11.XFlush(self.display)

    def wait_for(self, name):
        """Serves the window until it sends this message; its data."""
        end = time.monotonic() + 30
        while time.monotonic() < end:
            if not x11.XPending(self.display):
                time.sleep(0.01)
                continue
            event = Event()
            x11.XNextEvent(self.display, ctypes.byref(event))
            if event.type == SELECTION_REQUEST:
                self.answer(event.request)
            elif event.type == CLIENT_MESSAGE and event.client.message_type == self.atom(name):
                return list(event.client.data)
        sys.exit(f"the window sent no {name}")


def main():
    window, x, y, path = int(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3]), sys.argv[4]
    drag = Drag(window, path)
    drag.send("XdndEnter", 5 << 24, drag.atom("text/uri-list"), 0, 0)
    drag.send("XdndPosition", 0, x << 16 | y, 0, drag.atom("XdndActionCopy"))
    if not drag.wait_for("XdndStatus")[1] & 1:
        sys.exit("the window takes no files")
    drag.send("XdndDrop", 0, 0, 0, 0)
    if drag.wait_for("XdndFinished")[1] == 0:  # GLFW answers with the length of what it read
        sys.exit("the window did not take the file")


main()
