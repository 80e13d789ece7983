"""The line in which ritz-run says how well a nonlinear motion keeps its energy."""
import re


def gained_and_lost(text):
    """Both relative to what there was at the beginning and what the loads brought; None where nothing is said."""
    said = re.search(r"at most (\S+) J gained and (\S+) J lost; .* at most (\S+) J", text)
    if not said:
        return None
    gained, lost, brought = map(float, said.groups())
    return (gained / brought, lost / brought) if brought > 0 else None
