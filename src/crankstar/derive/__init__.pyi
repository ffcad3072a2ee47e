"""The public names of the room, each loaded on first use: of a search the algebra alone."""

from .chapters import Chapter as Chapter, Derivation as Derivation
from .expansion import motion_chapter as motion_chapter
from .families import family as family
from .firing_sums import gas_orders as gas_orders
from .records import DerivationError as DerivationError, Line as Line, Step as Step
from .six_signs import Sign as Sign, signs as signs, signs_chapter as signs_chapter
from .steps import derivation as derivation
from .torques import inertia_torque as inertia_torque
from .twist_sums import twist_orders as twist_orders
