"""The paper on trial: every printed claim, checked anew when the audit runs."""
