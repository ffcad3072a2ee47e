"""How thoroughly random engines are tried: `HYPOTHESIS_PROFILE=long` for many, `explore` for others each time."""

import os

from hypothesis import HealthCheck, settings

SLOW = [HealthCheck.too_slow]

settings.register_profile("default", max_examples=20, derandomize=True, deadline=None, database=None, suppress_health_check=SLOW)
settings.register_profile("long", settings.get_profile("default"), max_examples=300)
settings.register_profile("explore", settings.get_profile("long"), derandomize=False)
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "default"))
