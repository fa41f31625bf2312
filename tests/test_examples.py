"""Does each example run, and does the README's first one?"""

import re
import runpy
from pathlib import Path

import pytest

import drawbar
from drawbar.study.paper.examples import EXAMPLES as EXAMPLES_OF_LOGS
from drawbar.study.paper.examples import example_log, make

ROOT = Path(__file__).parent.parent
EXAMPLES = sorted((ROOT / "examples").glob("*.py"))

# One number that each must print.
PRINTS = {
    "how_hard_does_it_pull": r"at most 92\.6 mN",
    "what_is_my_tissue": r"the wheel pulls \d+\.\d mN",
    "does_the_model_fit_my_rig": r"\b3\.0",
    "does_it_settle": r"damper 0\.5 N s/m: sinkage still swings by 0\.000 mm",
}


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda p: p.stem)
def test_an_example_runs_and_answers_its_question(path, capsys):
    runpy.run_path(str(path))
    assert re.search(PRINTS[path.stem], capsys.readouterr().out)


def test_the_first_example_of_the_readme_is_short_and_prints_what_it_says(capsys):
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    code, printed = re.findall(r"```python\n(.*?)```\s*\n```text\n(.*?)```", readme, re.DOTALL)[0]
    assert len(code.strip().splitlines()) <= 15
    exec(compile(code, "README.md", "exec"), {})
    assert capsys.readouterr().out.strip() == printed.strip()


@pytest.mark.parametrize("name", EXAMPLES_OF_LOGS)
def test_the_shipped_logs_are_the_virtual_rigs_own(name, tmp_path):
    shipped, again = drawbar.load(example_log(name)), drawbar.load(make(name, tmp_path))
    assert shipped.attrs["origin"] == "virtual rig"
    for column in shipped.data_vars:
        assert again[column].values == pytest.approx(shipped[column].values, rel=2e-4, abs=1e-6, nan_ok=True), column
