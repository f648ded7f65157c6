# The tutorial from Python: a notebook as a script. Jupyter (with jupytext), VS Code and Spyder open it cell by cell; `python3
# tutorial.py [DATA]` runs it as a whole in under a minute. DATA is the folder with percal's data.

# %% [markdown]
# # percal in five cells
# A curve is fitted, a ball is shot, the shot is carried to another scale, a gel is calibrated on curve and depths together, and the
# result becomes a material card. All numbers are SI.

# %%
import sys
import tempfile
from pathlib import Path

import percal

here = Path(__file__).resolve().parent if "__file__" in globals() else Path.cwd()
data = Path(sys.argv[1]) if len(sys.argv) > 1 else here.parent.parent / "data"
print("percal", percal.__version__)

# %% [markdown]
# ## 1. Fit a curve
# Gelatin in compression and tension; the file's header carries the units. Every minimum is kept: look at the second best before you
# trust the sign of alpha.

# %%
fit = percal.fit_csv(data / "synthetic" / "gelatin_12wt_quasistatic.csv")
print(fit)
print("minima:", fit.minima)
print("equibiaxial, stretch 1.2:", fit.predict([1.2], "equibiaxial"), "Pa nominal")

# %% [markdown]
# ## 2. Shoot a ball
# A steel BB at 180 m/s into 10 % gelatin, the scene of `percal new scene`, on a mesh that is coarse on purpose. The depth is the mean
# of five runs over the mesh phase.

# %%
bb = percal.Scene.from_dict(
    {
        "particle": {"name": "BB", "diameter": "4.5 mm", "density": "7800 kg/m3", "speed": "180 m/s"},
        "target": {"name": "gelatin", "density": "1010 kg/m3", "mu": "346 kPa", "alpha": 8.65, "depth": "150 mm", "erosion": {"strain": 1.0}},
    }
)
print(percal.impact(bb, elements_per_radius=5))

# %% [markdown]
# A thesis's gold sphere into skin.

# %%
scene = percal.Scene.read(data / "guha2009" / "gold.toml")
shot = percal.impact(scene, elements_per_radius=5)
print(scene)
print(shot)
for warning in shot.warnings:
    print("warning:", warning)
slower = percal.impact(scene.changed(particle={"speed": "500 m/s"}), elements_per_radius=5)
print("at 500 m/s:", slower)

# %% [markdown]
# ## 3. The same impact at another scale
# A steel ball of 3.18 mm in gelatin is similar to the gold sphere of 2 um in skin: the same dimensionless problem.

# %%
similar = percal.scale(data / "guha2009" / "similar.toml")
print(similar)
steel = percal.impact(similar.similar_scene(), elements_per_radius=5)
print(steel, "- in radii", steel.depth / 1.59e-3, "and", shot.depth / 1e-6)

# %% [markdown]
# ## 4. Curve and depths together
# Modulus, exponent and erosion strain of a gel. The data are synthetic, made with 120 kPa, 6 and 1.1. Ten seconds, on meshes too
# coarse for a result; the ridge says which pairs of modulus and erosion strain the data cannot tell apart.

# %%
with tempfile.TemporaryDirectory() as folder:
    store = Path(folder) / "percal.store"
    found = percal.calibrate(data / "synthetic" / "joint_small.toml", store=store, announce=print)
hypothesis = found.hypotheses[0]
print(hypothesis)
print(hypothesis.ridges[0])
for finding in hypothesis.findings:
    print("note:", finding)

# %% [markdown]
# ## 5. A card for your solver
# The modulus is converted to what the solver means by it, and the card says so in its comments.

# %%
gel = percal.CardMaterial(
    name="gel",
    density=1010,
    mu=hypothesis.parameters["mu"],
    alpha=hypothesis.parameters["alpha"],
    bulk_modulus=100 * hypothesis.parameters["mu"],
    erosion_strain=hypothesis.parameters["erosion_strain"],
    comments=["from the tutorial, on meshes too coarse for a result"],
)
print(gel)
print(percal.write_card(gel, "lsdyna", units="mm-t-s-MPa"))
