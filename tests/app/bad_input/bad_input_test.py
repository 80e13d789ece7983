"""Everything that a user can get wrong, one row each: the exit code, one sentence that says what and where, in time,
and nothing left behind."""
import sys
from concurrent.futures import ThreadPoolExecutor

import basis_cases
import full_cases
import mesh_cases
import model_cases
import option_cases
import runner

AT_ONCE = 2
SECONDS = 5

cases = [*mesh_cases.CASES, *option_cases.CASES, *basis_cases.CASES, *model_cases.CASES, *full_cases.CASES]
if len(sys.argv) > 1:
    cases = [case for case in cases if sys.argv[1] in case.name]


def complaints(case, answer):
    """Whoever was slow is timed again, alone: the machine may have been busy."""
    if answer.seconds > SECONDS and (again := runner.run(case).seconds) > SECONDS:
        return [*answer.complaints, f"took {answer.seconds:.1f} and {again:.1f} s"]
    return answer.complaints


with ThreadPoolExecutor(AT_ONCE) as pool:
    answers = list(pool.map(runner.run, cases))
failed = 0
for case, answer in zip(cases, answers):
    if wrong := complaints(case, answer):
        failed += 1
        print(f"FAILED {case.name}: {'; '.join(wrong)}\n  {' '.join(map(str, case.words))}\n"
              f"  stderr: {answer.said.strip()}")
print(f"{len(cases) - failed} of {len(cases)} cases are answered as they should be")
sys.exit(bool(failed))
