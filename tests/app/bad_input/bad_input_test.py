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

cases = [*mesh_cases.CASES, *option_cases.CASES, *basis_cases.CASES, *model_cases.CASES, *full_cases.CASES]
if len(sys.argv) > 1:
    cases = [case for case in cases if sys.argv[1] in case.name]


def verdict(case):
    complaints, said = runner.run(case)
    return case, complaints, said


with ThreadPoolExecutor(AT_ONCE) as pool:
    verdicts = list(pool.map(verdict, cases))

# A busy machine can make a run slow: whoever failed is heard once more, alone.
failed = [v for v in (verdict(case) for case, complaints, said in verdicts if complaints) if v[1]]
for case, complaints, said in failed:
    print(f"FAILED {case.name}: {'; '.join(complaints)}\n  {' '.join(map(str, case.words))}\n  stderr: {said.strip()}")
print(f"{len(cases) - len(failed)} of {len(cases)} cases are answered as they should be")
sys.exit(bool(failed))
