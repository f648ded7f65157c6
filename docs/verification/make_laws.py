"""Writes docs/verification/laws.md from the results of two jobs of data/guha2009.

    percal calibrate data/guha2009/gold_laws.toml                        # likewise gelatin_laws.toml
    python3 docs/verification/make_laws.py gold_laws.out/result.json gelatin_laws.out/result.json
"""
import argparse
import json
import pathlib
import statistics

from harness import PAGES, number, percent, processor, table
from make_calibration import interval, mean_deviation, pressure
from make_erosion_length import aicc, left_out, length_words


def models(result):
    return [(h["name"], h) for h in result["hypotheses"]] + [("Dehn's closed form", result["dehn"])]


def within(model):
    """How many shots lie in the 95 % interval that the others predict for them."""
    prediction = model["leave_one_out"][0]["prediction"]
    return f"{prediction['within_interval']} of {prediction['shots']}"


def cross(result, name):
    """Mean |deviation| of a cross-validation under each hypothesis and Dehn's form, by their names."""
    return {model_name: percent(next(one for one in model["cross_validations"] if one["name"] == name)["prediction"]["mean_deviation"]) for model_name, model in models(result)}


def power(result, law, name):
    """A law's power with its interval in words."""
    hypothesis = next(h for h in result["hypotheses"] if h["name"] == law)
    parameter = next(p for p in hypothesis["parameters"] if p["name"] == name)
    return f"{number(parameter['value'])} ({interval(parameter, number)})"


def verdict(gold, gelatin):
    def both(law):
        return tuple(percent(left_out(dict(models(result))[law])) for result in (gold, gelatin))
    small, middle, carbide = (cross(gelatin, name) for name in ("3.18 mm steel -> 1.59 mm", "3.18 mm steel -> 2.39 mm", "steel -> tungsten carbide"))
    dehn = "Dehn's closed form"
    return f"""- **Rate.** A modulus that goes as v/a to the power {power(gelatin, "rate", "rate_power")} in gelatin and {power(gold, "rate", "rate_power")} in skin predicts what the job without a law misses most, the smaller balls from the largest:
  {small["neither"]} become {small["rate"]} and {middle["neither"]} become {middle["rate"]} (Dehn: {small[dehn]} and {middle[dehn]}), from one size alone, whose speeds tell the power. Each shot left out: {both("neither")[0]} become {both("rate")[0]} of gold, {both("neither")[1]} become {both("rate")[1]} of gelatin.
- **Size.** An erosion strain that falls with the radius does about as well for the shots left out ({both("size")[0]} and {both("size")[1]}), and nothing where one size has to predict another, since one size tells no power; tungsten carbide gets worse ({carbide["neither"]} to {carbide["size"]}).
- **Both.** Shots of three sizes at similar speeds do not tell the two apart: both powers together have 0 in their intervals, and AICc is worse.
- **Dehn's closed form**, with two numbers, still predicts tungsten carbide best ({carbide[dehn]}; with the rate {carbide["rate"]}), and no law repairs titanium.
- By AICc alone nothing is decided between neither, rate, size and Dehn. An erosion length does less for the sizes and more harm to tungsten carbide (erosion_length.md)."""


def fit_rows(data, result):
    for name, model in models(result):
        fresh = model.get("fresh_mean_deviation")
        yield [data, name, len(model["parameters"]), percent(mean_deviation(model["shots"])), percent(fresh) if fresh is not None else "-",
               percent(left_out(model)), within(model), aicc(model)]


def size_rows(result):
    shots = result["data"]["shots"]
    for radius in sorted({shot["radius_m"] for shot in shots}):
        def mean(model):
            return statistics.mean(s["deviation"] for s in model["leave_one_out"][0]["shots"] if shots[s["shot"]]["radius_m"] == radius)
        yield [length_words(radius), sum(shot["radius_m"] == radius for shot in shots), *(percent(mean(model), "+.1f") for _, model in models(result))]


def cross_rows(result):
    for k, one in enumerate(result["dehn"]["cross_validations"]):
        yield [one["name"], *(percent(model["cross_validations"][k]["prediction"]["mean_deviation"]) for _, model in models(result))]


def parameter_rows(data, result):
    for hypothesis in result["hypotheses"]:
        for p in hypothesis["parameters"]:
            show = pressure if "value_Pa" in p else number
            yield [data, hypothesis["name"], p["name"], show(p["value_Pa"] if "value_Pa" in p else p["value"]), interval(p, show), "yes" if p["identifiable"] else "no"]


def cost_row(data, result):
    emulator = result["emulator"]
    return [data, emulator["rounds"][-1]["runs"], percent(emulator["leave_one_out_error"]), percent(emulator["error_at_optimum"]), f"{result['cost']['cpu_s']:.0f}", f"{result['cost']['wall_s']:.0f}"]


def page(gold, gelatin):
    names = [name for name, _ in models(gold)]
    both = [("gold, 9 shots", gold), ("gelatin, 24 shots", gelatin)]
    return f"""# Laws of rate and size

Written by docs/verification/make_laws.py from the results of data/guha2009/gold_laws.toml and gelatin_laws.toml. The laws: docs/theory/calibration.md (3a), (3b).

Does the modulus follow the rate v/a, does the erosion strain follow the sphere's radius, do both or neither? mu and the erosion strain are free in all four, alpha is held at 8.5, each element is judged by itself on the same number of elements per radius
for all sizes. Mean |deviation| of the fitted depths by the emulator, by fresh runs at the best point, and of each shot predicted from all others. AICc is that of ln depth over the fitted shots, lower is better; differences of a few mean nothing.

{table(["data", "law", "free numbers", "fitted", "fresh runs", "each left out", "of these within 95 %", "AICc"], [row for data, result in both for row in fit_rows(data, result)])}

{verdict(gold, gelatin)}

## What is predicted from what

Gelatin, mean |deviation|:

{table(["", *names], cross_rows(gelatin))}

## Is there a trend with the size?

Mean signed deviation of the shots of each size, each predicted from all others.

Gold:

{table(["radius", "shots", *names], size_rows(gold))}

Gelatin:

{table(["radius", "shots", *names], size_rows(gelatin))}

## Parameters

{table(["data", "law", "parameter", "best", "95 % (profile)", "can be known"], [row for data, result in both for row in parameter_rows(data, result)])}

## Cost

{table(["data", "runs", "emulator, each left out", "emulator at the best points", "CPU s", "wall s"], [cost_row(data, result) for data, result in both])}

On {processor()}, {gold["cost"]["isa"]}, beside other work.
"""


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("gold")
    parser.add_argument("gelatin")
    arguments = parser.parse_args()
    gold, gelatin = (json.loads(pathlib.Path(file).read_text()) for file in (arguments.gold, arguments.gelatin))
    (PAGES / "laws.md").write_text(page(gold, gelatin))
