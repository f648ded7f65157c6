"""The five shots that the mesh and its rules were chosen by, without dimensions: radius, speed and target density are 1."""

# Name; pi4, alpha, rho_p/rho_t, K/mu, width and depth in radii, erosion strain; replicates.
SCENES = [
    ("S, gold in skin", 6.6474, 8.5, 16.8, 50, 5, 75, 0.7, 5),
    ("M, gold in skin of 55 MPa", 1.813, 8.5, 16.8, 50, 5, 75, 0.3, 5),
    ("P, PMMA at 80 m/s in gel of 478 kPa", 13.52, 11, 1.139, 150, 8, 40, 0.35, 5),
    ("F, steel BB at 180 m/s in gel of 55 kPa", 601, 13.8, 7.573, 800, 15, 150, 0.626, 3),
    ("U, steel BB at 190 m/s in gel of 314 kPa", 118.4, 3.95, 7.573, 400, 12, 100, 2.98, 3)]


def scene(pi4, alpha, density, bulk, width, depth, strain, particle="", erosion=""):
    """`particle` and `erosion`: further lines of these tables."""
    return f"""[particle]
radius = "1 m"
density = "{density} kg/m3"
speed = "1 m/s"
{particle}

[target]
density = "1 kg/m3"
mu = "{1 / pi4:.12g} Pa"
alpha = {alpha}
bulk_to_shear = {bulk}
depth = "{depth} m"
width = "{width} m"

[target.erosion]
strain = {strain}
{erosion}
"""
