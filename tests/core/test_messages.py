# SPDX-License-Identifier: LGPL-2.1-or-later
"""Messages go to another process as data, and are worded there."""

from __future__ import annotations

import json

import numpy as np
import pytest

from millcorr.errors import UsageError, unsaid
from millcorr.messages import (
    Accept,
    Accepted,
    Place,
    Wording,
    as_data,
    message,
    message_of,
    mm,
    of_data,
    option,
    phrase,
    remedy,
    um,
    xy,
)


@pytest.mark.parametrize(
    "said",
    [
        "plain",
        phrase("{} is more than {}: {}", mm(0.25), um(1.5e-3), remedy("limit", 0.5)),
        message(Place("a.csv", 3), ": ", phrase("{:.2f} {!r} at {}", np.float64(1.234), "x", xy(1.0, 2.0))),
        phrase("{} and {}", phrase("{} left", np.int64(3)), message(option("depth", (0.4, 0.5)), Accept("ball"))),
        unsaid("why", option("points", of="KIND")).message,
        UsageError(option("setup"), " is missing").message,
        phrase("accepted {}: {}", Accepted("unmeasured", (1.0, -2.5)), "a side"),
    ],
)
def test_a_message_goes_to_another_process(said):
    back = of_data(json.loads(json.dumps(as_data(said))))
    assert back == said
    assert back.pieces == message_of(said).pieces

    class Other(Wording):
        def template(self, text):
            return f"<{text}>"

        def piece(self, piece):
            return f"[{piece}]"

    assert back.in_words(Other()) == message_of(said).in_words(Other())


@pytest.mark.parametrize(
    "data", [3, {"a": 1}, [{"Command": {}}], [{"Length": {"cm": 1}}], [{"Phrase": {}, "Place": {}}]]
)
def test_what_is_no_message_is_told(data):
    with pytest.raises(ValueError):
        of_data(data)
