"""A thread of its own for a library that wants all its calls from one and the same."""

import threading
from collections.abc import Callable
from concurrent.futures import Future
from queue import SimpleQueue
from typing import Any, TypeVar

Result = TypeVar("Result")


class OneThread:
    """Runs calls one after another in one thread, whichever threads ask for them.

    The thread begins with the first call and ends with the process. What calls make for later ones has to be
    let go of by a call, too.
    """

    def __init__(self, name: str) -> None:
        self._name = name
        self._calls: SimpleQueue[tuple[Callable[[], Any], Future[Any]]] = SimpleQueue()
        self._beginning = threading.Lock()
        self._thread: threading.Thread | None = None

    def begun(self) -> bool:
        """Tell whether there has been a call."""
        return self._thread is not None

    def run(self, call: Callable[[], Result]) -> Result:
        """Return what a call returns, or raise what it raises."""
        with self._beginning:
            if self._thread is None:
                # a daemon, so that the process may end, and be told to by functions that run at its exit
                self._thread = threading.Thread(target=self._work, name=self._name, daemon=True)
                self._thread.start()
        if threading.current_thread() is self._thread:
            return call()
        answer: Future[Result] = Future()
        self._calls.put((call, answer))
        return answer.result()

    def _work(self) -> None:
        while True:
            _answer(*self._calls.get())


def _answer(call: Callable[[], Any], answer: "Future[Any]") -> None:
    """Make a call; a function of its own keeps nothing of it alive until the next one."""
    try:
        answer.set_result(call())
    except BaseException as error:  # noqa: BLE001 - whoever asked for the call gets it
        answer.set_exception(error)
