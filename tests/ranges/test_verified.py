from mpsolve.certificate.format import Certificate
from mpsolve.errors import CertificateError
from mpsolve.outcome import Status
from mpsolve.ranges.verified import verified


def test_what_is_not_asked_for_is_not_made() -> None:
    def never() -> Certificate:
        raise AssertionError

    made = verified(never, 10, check=False)
    assert (made.status, made.certificate) == (Status.UNVERIFIED, None)
    assert "not asked" in made.note


def test_a_certificate_that_cannot_be_made_says_why() -> None:
    def fails() -> Certificate:
        raise CertificateError("no power of two")

    made = verified(fails, 10, check=True)
    assert (made.status, made.certificate, made.note) == (Status.UNVERIFIED, None, "no power of two")


def test_a_certificate_that_is_refused_is_none() -> None:
    made = verified(lambda: Certificate({"kind": "stable"}), 10, check=True)
    assert (made.status, made.certificate) == (Status.UNVERIFIED, None)
    assert made.note
