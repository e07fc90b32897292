# SPDX-License-Identifier: Apache-2.0
"""Test what notebooks show: pictures, plots, live pages; execute the notebooks of the package."""
import base64
import re
import shutil
import urllib.error
import urllib.request

import pytest

import hawser
from hawser import notebook

from conftest import ROOT

NOTEBOOKS = sorted((ROOT / "python/notebooks").glob("*.ipynb"))


def pictures(html):
    """Return the PNG files of an HTML text."""
    return [base64.b64decode(data) for data in
            re.findall(r'src="data:image/png;base64,([^"]+)"', html)]


def pixels(png):
    """Return the picture as an array (rows, columns, channels)."""
    import io
    pyplot = pytest.importorskip("matplotlib.pyplot")
    return pyplot.imread(io.BytesIO(png))


@pytest.fixture
def crane(scenes, program, monkeypatch):
    monkeypatch.setenv("HAWSER_PROGRAM", program)
    return hawser.load(scenes / "crane_knuckle.json")


def test_a_session_shows_its_present_state(crane):
    crane.step(10)
    before = crane.world.state_hash
    html = crane._repr_html_()
    assert len(pictures(html)) == 1 and "crane.radius" in html
    assert crane.world.state_hash == before
    first = pixels(crane.picture(size=(400, 300)))
    assert abs(first.shape[0] - 300) <= 1 and abs(first.shape[1] - 400) <= 1
    assert first.std() > 0.01
    crane.inputs["crane.slew"] = 0.06
    crane.run(5.0, progress=False)
    assert (pixels(crane.picture(size=(400, 300))) != first).any()


def test_a_recording_shows_picture_and_plot(scenes, program, monkeypatch, tmp_path):
    monkeypatch.setenv("HAWSER_PROGRAM", program)
    session = hawser.load(scenes / "moored_barge.json", record=tmp_path / "run.hwr")
    session.run(1.0, progress=False)
    session.finish()
    recording = hawser.Recording(tmp_path / "run.hwr")
    assert len(pictures(recording._repr_html_())) == 2
    assert recording.picture(0.0) != recording.picture()
    with recording.view() as page:
        assert urllib.request.urlopen(page.url).status == 200


def test_a_page_ends_when_it_is_closed(crane):
    crane.step(10)
    with crane.view(height=300) as page:
        assert page.url.startswith("http://127.0.0.1:")
        assert f'<iframe src="{page.url}"' in page._repr_html_()
        assert 'height="300"' in page._repr_html_()
        assert urllib.request.urlopen(page.url).status == 200
    with pytest.raises(urllib.error.URLError):
        urllib.request.urlopen(page.url)
    assert "<iframe" not in page._repr_html_()


def test_without_the_program_the_outputs_remain(crane, monkeypatch):
    monkeypatch.delenv("HAWSER_PROGRAM")
    monkeypatch.setattr(notebook, "__file__", "/none/none/none.py")
    monkeypatch.setenv("PATH", "/none")
    html = crane._repr_html_()
    assert "not found" in html and "crane.radius" in html and not pictures(html)
    with pytest.raises(hawser.Error, match="HAWSER_PROGRAM"):
        crane.view()


def test_a_page_that_fails_names_the_reason(crane, tmp_path):
    (tmp_path / "bad.json").write_text("{")
    with pytest.raises(hawser.Error, match="hawser view: .*bad.json"):
        notebook.open_page([str(tmp_path / "bad.json")], 300)


def test_there_are_five_notebooks():
    assert len(NOTEBOOKS) == 5


@pytest.mark.parametrize("file", NOTEBOOKS, ids=lambda f: f.stem)
def test_notebooks_execute(file, program, tmp_path, monkeypatch):
    nbformat, nbclient = pytest.importorskip("nbformat"), pytest.importorskip("nbclient")
    pytest.importorskip("ipykernel")
    book = nbformat.read(file, as_version=4)
    assert all(not cell.get("outputs") for cell in book.cells)
    shutil.copytree(ROOT / "scenes", tmp_path / "scenes")
    monkeypatch.setenv("HAWSER_PROGRAM", program)
    monkeypatch.setenv("PYTHONPATH", str(ROOT / hawser.__path__[0]).removesuffix("/hawser"))
    client = nbclient.NotebookClient(book, timeout=300, kernel_name="python3",
                                     resources={"metadata": {"path": str(tmp_path)}})
    client.execute()
    shown = [data for cell in book.cells if cell.cell_type == "code"
             for output in cell.outputs for data in output.get("data", {})]
    assert "image/png" in shown or "text/html" in shown
