# %% [markdown]
# # What a study found, and how a body moved
#
# Two figures from plain files: the work-precision diagram of a scenario, and the height of a body over time.
#
#     plumbline study A20 --quick --out study
#     plumbline simulate falling_cube --seconds 5 --trace fall.csv --every 0.02
#     python3 docs/notebook/findings.py study/findings.csv fall.csv
#
# Needs pandas and matplotlib. The `%%` marks make it a notebook in editors that know them.

# %%
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import pandas as pd


# %%
def work_precision(findings_csv, subject=None):
    """Error over cost, a line a solver; those points that are not finite or failed are left out."""
    points = pd.read_csv(findings_csv)
    subject = subject or points.subject.iloc[0]
    points = points[(points.subject == subject) & (points.status == "done") & points.error.notna()]
    metric = points.metric.iloc[0]
    points = points[points.metric == metric]
    figure, axes = plt.subplots(figsize=(6.4, 4.4))
    for solver, those in points.groupby("solver"):
        axes.loglog(those.ms_per_s_median, those.error.clip(lower=1e-9), "o", label=solver)
    axes.set(xlabel="CPU ms a simulated second", ylabel=f"relative error of {metric}", title=subject)
    axes.legend()
    axes.grid(alpha=0.3)
    return figure


# %%
def height_over_time(trace_csv, body=None):
    """Of one body of a trace."""
    trace = pd.read_csv(trace_csv)
    body = body or trace.body.iloc[0]
    those = trace[trace.body == body]
    figure, axes = plt.subplots(figsize=(6.4, 4.4))
    axes.plot(those.time_s, those.y_m)
    axes.set(xlabel="time, s", ylabel="height, m", title=body)
    axes.grid(alpha=0.3)
    return figure


# %%
if __name__ == "__main__":
    findings, trace = sys.argv[1:3]
    work_precision(findings).savefig("work_precision.png", dpi=120)
    height_over_time(trace).savefig("height.png", dpi=120)
