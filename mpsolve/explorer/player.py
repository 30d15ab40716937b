"""What moves on the page: the motion after the vehicle is put on the track, and the shape of the rail with bodies.

It is played by itself only where that is wanted, paused and wound; and the colours of the page.
"""

from __future__ import annotations

import numpy as np
from flint import acb, arb

from mpsolve.pictures import axes as pictures
from mpsolve.pictures import lines
from mpsolve.pictures.shape import moving_shape, numbered, shape_along, shape_in_time, stretch
from mpsolve.problem.problem import Problem
from mpsolve.vibration.response import response

STYLE = """
.player .controls { display: flex; gap: 0.75rem; align-items: center; max-width: 46rem; flex-wrap: wrap; }
.player button { border: 1px solid currentColor; border-radius: 4px; padding: 0.2rem 0.9rem; min-width: 5rem; }
.player input { flex: 1; min-width: 8rem; }
.player output { min-width: 5rem; }
"""

SCRIPT = """<script>
(() => {
  const still = matchMedia('(prefers-reduced-motion: reduce)');
  function begin(player) {
    const [svg, button, range, said] = ['svg', 'button', 'input', 'output'].map(name => player.querySelector(name));
    const [lasts, played, end] = ['lasts', 'played', 'end'].map(name => parseFloat(player.dataset[name]));
    let going;
    const show = () => {
      const t = svg.getCurrentTime() % played / played * lasts;
      range.value = t;
      said.textContent = t.toPrecision(3) + ' s' + (t > end ? ', after a lift-off: beyond the model' : '');
    };
    const set = on => {
      going = on;
      on ? svg.unpauseAnimations() : svg.pauseAnimations();
      button.textContent = on ? 'Pause' : 'Play';
    };
    const step = () => {
      if (!player.isConnected) return;
      if (going) show();
      requestAnimationFrame(step);
    };
    button.onclick = () => set(!going);
    range.oninput = () => { set(false); svg.setCurrentTime(range.value / lasts * played * 0.99999); show(); };
    set(!still.matches);
    show();
    step();
  }
  new MutationObserver(() => {
    if (still.matches) document.querySelectorAll('#shape svg').forEach(svg => svg.pauseAnimations());
    for (const player of document.querySelectorAll('.player:not([data-ready])')) {
      player.dataset.ready = '';
      begin(player);
    }
  }).observe(document, { childList: true, subtree: true });
})();
</script>"""
BLUE = "#1f5f99"
CSS = (
    pictures.STYLE
    + STYLE
    + """
:root { --blue: #0072b2; --red: #c44e00; --green: #00805f; --pink: #a8588a; --faint: #6d747b; --soft: #55606b; }
.body--dark { --blue: #64b5f0; --red: #ff9a57; --green: #4fd1a5; --pink: #e39ac6; --faint: #97a0a8; --soft: #a9b2bb; }
.q-btn { text-transform: none; }
#plane svg, #shape svg, #chart svg, #motion svg, #moving svg { max-width: 46rem; }
"""
)


def player(picture: str, lasts: float, played: float, end: float | None) -> str:
    """A moving picture of `lasts` seconds that are played in others, with a button and a slider of time.

    end: from which time on it is beyond the model.
    """
    beyond = "" if end is None else f' data-end="{end:.6g}"'
    return (
        f'<div class="player" data-lasts="{lasts:.6g}" data-played="{played:g}"{beyond}>{picture}'
        '<div class="controls"><button type="button">Pause</button>'
        f'<input type="range" min="0" max="{lasts:.6g}" step="{lasts / 100:.6g}" value="0" aria-label="Time, s"/>'
        "<output></output></div></div>"
    )


POINTS = 401
PLACES = 81
EVERY = 4
"""Of the times: those at which the shape is drawn."""
PLAYED = 8.0  # s
_SHOWN = 4
_SPREAD = 1e-12


def motion_pictures(problem: Problem, seconds: float) -> tuple[str, str]:
    """Two pictures of curves, in mm and kN, grey after the first lift-off; and the motion, played in PLAYED seconds.

    Errors as of `response`.
    """
    x = stretch(problem, PLACES)
    contacts = problem.pencil.places
    found = response(problem, times=np.linspace(0.0, seconds, POINTS), places=[*contacts, *x.tolist()])
    end = None if found.lift_off is None else float(found.lift_off.time)
    shape = found.rail[len(contacts) :, ::EVERY].T
    bodies = {name: moved[::EVERY] for name, moved in found.vehicle.items()}
    drawn = shape_in_time(x, shape, contacts, bodies, PLAYED) + numbered(bodies)
    names = {k: f"contact {k + 1}" for k in range(0, len(contacts), max(1, -(-len(contacts) // _SHOWN)))}
    return "".join(lines.motion_pictures(found, names, True, prefix="motion-")), player(drawn, seconds, PLAYED, end)


def root_picture(problem: Problem, q: complex) -> str:
    """The shape of the root near q."""
    ball = acb(arb(q.real, _SPREAD * abs(q)), arb(q.imag, _SPREAD * abs(q)))
    x, rail, bodies = shape_along(problem, ball)
    return moving_shape(x, rail, problem.pencil.places, bodies, 2.0) + numbered(bodies)
