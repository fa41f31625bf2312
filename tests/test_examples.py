"""Does each example run, and does the README's first one?"""

import re
import runpy
from pathlib import Path

import pytest

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
