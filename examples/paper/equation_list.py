"""Equations (1) to (39) as printed, for `equations` (x_2 is the print's d̂, P its P_C1 as a scale)."""

from __future__ import annotations

from collections.abc import Callable

from mpsolve.claims import Claim, Finding

from . import equations as eq

_PLACE = "Sections 2 and 3"
_WAVE = "exp(I*(omega_f{0}*t + phi_f{0} + 3*pi/2))"
_SHORT = "exp(I*(omega_{0}*t + phi_{0} + 3*pi/2))"
_ACCELERATION = "d(w(x,t),t,2) + 2*v*d(w(x,t),x,t) + v**2*d(w(x,t),x,2)"
_BEAM = "EI*d(w(x,t),x,4) + (N - k_p)*d(w(x,t),x,2) + m*d(w(x,t),t,2) + c_b*d(w(x,t),t) + k*w(x,t)"
_MOVING = (
    "EI*d(w(s,t),s,4) + (N - k_p)*d(w(s,t),s,2) + m*(d(w(s,t),t,2) - 2*v*d(w(s,t),s,t) + v**2*d(w(s,t),s,2)) "
    "+ c_b*(d(w(s,t),t) - v*d(w(s,t),s)) + k*w(s,t)"
)


def _loads(wave: str, inertia: str, place: str) -> str:
    first, second = (f"P_C{j} + P_A{j}*{wave.format(j)}{inertia.format(j)}" for j in (1, 2))
    return f"({first})*delta({place}) + ({second})*delta({place} - d_2)"


def _two(order: str) -> str:
    return "load = " + _loads(_WAVE, " - M_{0}*d(w_0{0}(t),t" + order + ")", "x - v*t")


def _seven(wave: str) -> str:
    return "load = " + _loads(wave, " - M_{0}*(" + _ACCELERATION + ")", "x - v*t")


def _eight(wave: str) -> str:
    masses = f"M_1*delta(x - v*t)*({_ACCELERATION}) + M_2*delta(x - v*t - d_2)*({_ACCELERATION})"
    return f"{_BEAM} + {masses} = {_loads(wave, '', 'x - v*t')}"


def _nine(wave: str) -> str:
    return f"{_MOVING} = {_loads(wave, ' - M_{0}*d(w(s,t),t,2)', 's')}"


_THIRTEEN = (
    "d(what(xi,tau),xi,4) + 4*(eta_N - eta_S + alpha**2)*d(what(xi,tau),xi,2) + 4*d(what(xi,tau),tau,2) "
    "- 8*alpha*d(what(xi,tau),xi,tau) + 8*eta_b*(d(what(xi,tau),tau) - alpha*d(what(xi,tau),xi)) + 4*what(xi,tau) = "
    "4*(2*eta_C1 + 2*eta_A1*exp(I*(omegahat_f1*tau + phi_f1 + 3*pi/2)) - eta_M1*d(what(xi,tau),tau,2))*delta(xi) "
    "+ 4*(2*eta_C2 + 2*eta_A2*exp(I*(omegahat_f2*tau + phi_f2 + 3*pi/2)) - "
    "eta_M2*d(what(xi,tau),tau,2))*delta(xi - x_2)"
)
_FORCE = "8*eta_C{0}/(I*q) + 8*eta_A{0}*exp(I*(phi_f{0} + 3*pi/2))/(I*q - I*omegahat_f{0})"
_FIFTEEN = (
    "d(Wtilde(xi,q),xi,4) + 4*(eta_N - eta_S + alpha**2)*d(Wtilde(xi,q),xi,2) - 4*q**2*Wtilde(xi,q) - "
    "8*I*q*alpha*d(Wtilde(xi,q),xi) + 8*(I*q*eta_b*Wtilde(xi,q) - eta_b*alpha*d(Wtilde(xi,q),xi)) + 4*Wtilde(xi,q) = "
    f"({_FORCE.format(1)} + 4*eta_M1*q**2*Wtilde(xi,q))*delta(xi) + ({_FORCE.format(2)} + "
    "4*eta_M2*q**2*Wtilde(xi,q))*delta(xi - x_2)"
)
_POINT = f"({_FORCE.format(1)} + ({_FORCE.format(2)})*exp(-I*p*x_2)"
_INERTIA = "4*eta_M1*q**2*Wtilde(0,q) + 4*eta_M2*q**2*Wtilde(x_2,q)*exp(-I*p*x_2)"
_D = "D(p,q) = p**4 - 4*p**2*(eta_N - eta_S + alpha**2) - 4*q**2 + 8*alpha*p*q + 8*I*eta_b*(q - alpha*p) + 4"
_TWENTY = (
    "Wtilde(xi,q) = (F_1(q) + 2*eta_M1*q**2*Wtilde(0,q))*K(xi,q)/pi + (F_2(q) + "
    "2*eta_M2*q**2*Wtilde(x_2,q))*K(xi - x_2,q)/pi"
)
_AMPLITUDE = "F_{0}(q) = 4*eta_C{0}/(I*q) + 4*eta_A{0}*exp(I*(phi_f{0} + 3*pi/2))/(I*q - I*omegahat_f{0})"
_ROWS = (
    "Wtilde(0,q)*pi = (F_1(q) + 2*eta_M1*q**2*Wtilde(0,q))*K(0,q) + (F_2(q) + 2*eta_M2*q**2*Wtilde(x_2,q))*K(-x_2,q)",
    "Wtilde(x_2,q)*pi = (F_1(q) + 2*eta_M1*q**2*Wtilde(0,q))*K(x_2,q) + (F_2(q) + "
    "2*eta_M2*q**2*Wtilde(x_2,q))*K(0,q)",
)
_SYSTEM = (
    "(pi - 2*eta_M1*q**2*K(0,q))*Wtilde(0,q) - 2*eta_M2*q**2*K(-x_2,q)*Wtilde(x_2,q) = F_1(q)*K(0,q) + "
    "F_2(q)*K(-x_2,q)",
    "-2*eta_M1*q**2*K(x_2,q)*Wtilde(0,q) + (pi - 2*eta_M2*q**2*K(0,q))*Wtilde(x_2,q) = F_1(q)*K(x_2,q) + "
    "F_2(q)*K(0,q)",
)
_DET = "det(q) = (pi - 2*eta_M1*q**2*K(0,q))*(pi - 2*eta_M2*q**2*K(0,q)) - 4*eta_M1*eta_M2*q**4*K(x_2,q)*K(-x_2,q)"
_SOLVED = (
    "Wtilde(0,q) = ((pi - 2*eta_M2*q**2*K(0,q))*(F_1(q)*K(0,q) + F_2(q)*K(-x_2,q)) "
    "+ 2*eta_M2*q**2*K(-x_2,q)*(F_1(q)*K(x_2,q) + F_2(q)*K(0,q)))/det(q)",
    "Wtilde(x_2,q) = ((pi - 2*eta_M1*q**2*K(0,q))*(F_1(q)*K(x_2,q) + F_2(q)*K(0,q)) "
    "+ 2*eta_M1*q**2*K(x_2,q)*(F_1(q)*K(0,q) + F_2(q)*K(-x_2,q)))/det(q)",
)
_GENERAL = (
    "Wtilde(xi,q) = (F_1(q)*pi - 2*F_1(q)*eta_M2*q**2*K(0,q) + 2*F_2(q)*eta_M1*q**2*K(-x_2,q))/det(q)*K(xi,q) "
    "+ (F_2(q)*pi - 2*F_2(q)*eta_M1*q**2*K(0,q) + 2*F_1(q)*eta_M2*q**2*K(x_2,q))/det(q)*K(xi - x_2,q)"
)


def _equal(front: str, mass: str, end: str, slope: str = "det(q)") -> str:
    terms = (f"({front})*(pi - 2*{mass}*q**2*(K(0,q) - K({a}x_2,q)))/{slope}*K({b},q){end}"
             for a, b in (("-", "xi"), ("", "xi - x_2")))  # fmt: skip
    return " + ".join(terms)


_FIRST = "((8 + 20*q_lm**2 - q_lm**4 {} q_lm*(q_lm**2 + 8)**(3/2))/8)**(1/4)"
_STEADY = "4*eta_C/pi*K(xi,0) + 4*eta_C/pi*K(xi - x_2,0)"
_39 = "(-6*d(D_q(p)*{0},p)*{1} + 2*D_q(p)*{0}*{2})/(3*{3})"


def _claim(
    number: str, form: str | tuple[str, ...], corrected: str | tuple[str, ...] = (), slip: str = "",
    check: Callable[[Claim], Finding] = eq.equation, source: str | tuple[str, ...] = "",
) -> Claim:  # fmt: skip
    forms, right = ((e,) if isinstance(e, str) else e for e in (form, corrected))
    sources = (source or f"({number})",) if isinstance(source, str) else source
    at = {"source": sources} | ({"corrected": right, "slip": (slip,)} if right else {})
    return Claim(f"eq-{number.replace(', ', '-')}", _PLACE, f"Eq. ({number}): {{form}}", check, {"form": forms}, at)


_FREQUENCY = "The phases read ω_j t + φ_j; by (2) they are ω_fj t + φ_fj."

CLAIMS = (
    _claim("1", f"{_BEAM} = load"),
    _claim("2", _two(""), _two(",2"), "The inertia force needs the second time derivative, w_0j,tt."),
    _claim("3, 5", "d(w_0j(t),t) = v*d(w(x,t),x) + d(w(x,t),t)", source="(3), (5)"),
    _claim("4, 6", "d(w_0j(t),t,2) = v**2*d(w(x,t),x,2) + 2*v*d(w(x,t),x,t) + d(w(x,t),t,2)", source="(4), (6)"),
    _claim("7", _seven(_SHORT), _seven(_WAVE), _FREQUENCY),
    _claim("8", _eight(_SHORT), _eight(_WAVE), _FREQUENCY),
    _claim("9", _nine(_SHORT), _nine(_WAVE), _FREQUENCY),
    _claim("10", ("xi = chi*s", "tau = chi*v_cr*t", "what(xi,tau) = w(s,t)/w_st", "w_st = P*chi/(2*k)",
                  "chi = (k/(4*EI))**(1/4)", "v_cr = (4*k*EI/m**2)**(1/4)",
                  "omegahat_f1 = omega_f1/(chi*v_cr)"), source=("(10)", "(12)")),
    _claim("11", ("eta_b = c_b/(2*sqrt(m*k))", "eta_N = N/(2*sqrt(k*EI))", "eta_s = k_p/(2*sqrt(k*EI))"),
           ("eta_b = c_b/(2*sqrt(m*k))", "eta_N = N/(2*sqrt(k*EI))", "eta_S = k_p/(2*sqrt(k*EI))"),
           "The Pasternak ratio is η_s here and in α_cr,ex = √(1 − η_N + η_s), η_S from (13) on."),
    _claim("12", ("eta_C1 = P_C1/P", "eta_C2 = P_C2/P", "eta_A1 = P_A1/P", "eta_A2 = P_A2/P", "eta_M1 = M_1*chi/m",
                  "eta_M2 = M_2*chi/m", "alpha = v/v_cr")),
    _claim("13", _THIRTEEN),
    _claim("14", "exp(-qbar*tau)", check=eq.laplace),
    _claim("15", _FIFTEEN),
    _claim("16, 19", ("exp(-I*p*xi)", "exp(I*p*xi)/(2*pi)"), check=eq.fourier),
    _claim("17", f"W(p,q) = {_POINT})/D(p,q) + {_INERTIA}", f"W(p,q) = {_POINT} + {_INERTIA})/D(p,q)",
           "The mass terms stand outside 1/D; they belong inside."),
    _claim("18", _D),
    _claim("20", _TWENTY),
    _claim("21", "K(xi,q) = Integral(exp(I*p*xi)/D(p,q),(p,-oo,oo))"),
    _claim("22", (_AMPLITUDE.format(1), _AMPLITUDE.format(2))),
    _claim("23, 24", _ROWS, source="(23), (24)"),
    _claim("25", _SYSTEM),
    _claim("26", _DET),
    Claim("eq-26-one-place", _PLACE, "Eq. (26) is reduced to the characteristic equation of η_M = {form} for d̂ = 0.",
          eq.one_place, {"form": ("eta_M1 + eta_M2",)}),
    _claim("27, 28", _SOLVED, source="(27), (28)"),
    _claim("29", _GENERAL),
    _claim("30", "Wtilde(xi,q) = " + _equal("4*eta_C/(I*q)", "eta_M", "")),
    Claim("eq-31", _PLACE, "Eq. (31): a ensures that all singularities are located to the {side} from the "
    "integration line.",
          eq.side_of_singularities, {"side": ("right",)}),
    Claim("eq-31-inversion", _PLACE, "Eq. (31): f(t) is the limit T → ∞ of the integral of {form} (integrand, "
          "ends) ds.",
          eq.inversion_by_time, {"form": ("F(s)*exp(s*t)/(2*pi*I)", "a - I*T", "a + I*T")}),
    _claim("32", ("Wtilde(xi,q)*exp(I*q*tau)/(2*pi)", "-I*a - T", "-I*a + T"), check=eq.inversion),
    _claim("33", _FIRST.format("-"), check=eq.branch_of_the_limit),
    _claim("34", _FIRST.format("+"), check=eq.branch_of_the_limit),
    Claim("eq-33-damped", _PLACE, "For η_b < 1, (33) and (34) hold in the special case of η_N = η_S.",
          eq.limit_with_damping, {}, {"eta_b": ("0", "0.3", "0.6")}),
    _claim("35", _equal("4*eta_C/q", "eta_Mu", "*exp(I*q*tau)"), _equal("4*eta_C/q", "eta_M", "*exp(I*q*tau)"),
           "η_Mu stands for η_M.", eq.residues),
    _claim("36", (_STEADY, _equal("4*eta_C/q", "eta_Mu", "*exp(I*q*tau)", "det_q")),
           (_STEADY, _equal("4*eta_C/q", "eta_M", "*exp(I*q*tau)", "det_q")), "η_Mu stands for η_M.", eq.harmonics),
    _claim("37", "K(xi,q) = 2*pi*I*(exp(I*p*xi)/D_p(p_1) + exp(I*p*xi)/D_p(p_2))",
           "K(xi,q) = 2*pi*I*(exp(I*p_1*xi)/D_p(p_1) + exp(I*p_2*xi)/D_p(p_2))",
           "The exponents have p for p_j."),
    _claim("38", "K_q(xi,q) = Integral(-d(D(p,q),q)/D(p,q)**2*exp(I*p*xi),(p,-oo,oo))"),
    _claim("39", _39.format("exp(I*g*dhat)", "D_pp(p)**2", "D_ppp(p)**2", "D_pp(p)**2"),
           _39.format("exp(I*p*xi)", "h_pp(p)", "h_ppp(p)", "h_pp(p)**2"),
           "The exponent has d̂ for p, and D_pp², D_ppp² stand for (D²)_pp, (D²)_ppp, here h_pp, h_ppp with h = D².",
           eq.kernel_slope),
)  # fmt: skip
