"""What docs/verification/prisms.md says around the tables of make_prisms.py. The readings are of the figures that stand there: read them again when those change."""

HEAD = """# Prisms in plane strain

Prisms with the thickness that they have are in [three_dimensions.md](three_dimensions.md), which is the page to hold against measurements. Here every depth hangs on the wall; plane strain is for plates.

Written by `docs/verification/make_prisms.py` from `percal impact` ({machine}, one thread a run), from `data/guha2009/square.toml` and `rhombus.toml`: the steel prisms of
Guha 2009, chapter 5, into 12 wt% gelatin of 113 kPa (as printed, alpha 8.5). A half model is computed; for the square it has the bits of the whole. Depths in cm. ± is the
standard error of three runs over the phase of the mesh; a figure without it is one run, whose scatter is 1.7 times that error. W is the distance to the wall, which is fixed; h the side of the
square elements beside the middle line. A depth that W or h changes by more than {tolerated:.0f} % is marked "not converged", with what does it;
where the scatter of a run is as large, the mark can come from that.

"""

OWN = """## In the thesis's own domain

The wall stands at 7.95 mm, five radii of the thesis's 1.59 mm ball, the layer is 75 of them deep and has the model density of 464 kg/m3; the bottom is free. The mesh is the balls': {mesh} square columns
on 1.59 mm, {half} wider ones to the wall, though the prisms reach beyond 1.59 mm. K is 50 mu. Nothing is fitted for the square, whose erosion strain is the thesis's 0.51.

### Square, erosion strain 0.51

{square}
### Rhombus, erosion strain 0.57

Its own 0.975 is the next section's; 0.57 is the value with which the planning study came near LS-DYNA.

{rhombus}
### What this is worth

On the balls' mesh the unfitted square agrees with LS-DYNA, but neither its depths nor the rhombus's are converged. Columns that stay square to the half width change the square's by up to
{finer:.0f} %: between 1.59 mm and the edge of the particle, 4.12 mm, the balls' mesh has elements 0.2 to 1.5 mm wide. The wall decides more than anything else: at four times its distance the
square goes {wider:.1f} times as deep at 50 m/s. A prism in plane strain has to push the gelatin aside, and K = 50 mu between two rigid walls 15.9 mm apart leaves little room for that beside a
particle {across:.1f} mm wide. The agreement is one with a boundary condition and a mesh, and validates neither code.

"""

PRINTED = """## The rhombus at its printed erosion strain, 0.975, and 40 m/s

LS-DYNA finds 3.46 cm, 3.44 cm were measured. One run for each mesh of the thesis's own domain; the energies are shares of the impact energy.

{ladder}

What is explained: on the coarsest mesh no element reaches a stretch of 1.975, nothing erodes, and the rhombus rests on a dent that is shallower than itself. A sharp tip in contact strains the elements before it the
more the smaller they are, so whether anything erodes is the mesh's choice and not the material's. Where a channel is eroded, the energy of what is deleted belongs to a strip about an element wide, and no length
scale holds it when the elements shrink: the depth goes on rising with the mesh. Where the energy goes: up to {viscosity:.0f} % into bulk viscosity, most likely because an element that goes at a stretch near 2 with alpha 8.5
lets its neighbours recoil, and viscosity takes what rings. It is not what stops the particle: with both viscosity terms off at 30 elements the depth is {inviscid} cm instead of {viscous}, and the energy is found as kinetic and elastic instead.

What stays open: the finest mesh here, the thesis's element size, reaches {finest} cm, {short:.0f} % short of LS-DYNA, and nothing shows that the sequence ends. Erosion strain 0.975 does not carry over to this
solver; 0.57 does at 14 elements, in a domain whose wall decides. The thesis states neither its strain measure nor how its mesh was laid at the tip, so that why LS-DYNA needed 0.975 is not answered.

"""

MOULD = """## In the mould

The gelatin was cast 75 mm wide and 100 mm deep: wall at 37.5 mm, bottom held. Square columns go to the half width of the prism, then each is wider than the last by {growth:.0f} %; {mesh} elements on 1.59 mm (h). 464 kg/m3 was
chosen in the thesis for similarity with gold in skin; the gelatin that was shot at has 1010 kg/m3, which is what is physical and comes first. K is 100 mu there, for a Mach number below 0.3, and 50 mu at 464 kg/m3. For each shape the erosion
strain is found anew at the thesis's own calibration shot (square 50 m/s, rhombus 40 m/s: measured depth, mean of three runs, bisection to 1 % or to 0.002 of strain), and the other five shots are predicted.

{tables}
What else the calibrated shots at 1010 kg/m3 feel, three runs each:

{settings}

{reading}

"""

RANKING = """## Equal mass at 40 m/s (Table 5-3)

0.7027 g each: the rhombus as it is, a square of 5.64 mm, a steel ball of 2.78 mm radius. In the thesis's domain with 0.57, 0.51 and 0.7; in the mould with the strains found above and, for the ball, {ball:g}, found the same way
at the 3.18 mm ball's shot of 83 m/s (4.04 cm). The ball is axisymmetric, 10 elements on its radius, its wall at five radii in the thesis's domain. Three runs each; the prisms are as little converged as above. The thesis's column is itself computed, from
its lines of depth over speed.

{table}

{verdict}

"""

TURNED = """## Any orientation

The square at 50 m/s into the mould (1010 kg/m3, erosion strain {strain:g}, 7 elements on 1.59 mm, whole model), turned anticlockwise before the impact, with its rotation held or free; free, it may also move sideways. Three runs each, on one mesh and one wall.

{table}

{reading}
"""


MOULD_READING = """What the tables say:

- The wall. From 37.5 mm on, its distance changes the mean over the shots at 1010 kg/m3 by about a tenth at most, at W x 4 not more than at W x 2, with single runs that scatter by 5 to 15 %. The mould is wide enough
  as far as that lets one see; the thesis's 7.95 mm is not.
- The mesh. Depths grow as h shrinks, at every speed. Deletion of elements has no length scale, so that an erosion strain belongs to the mesh at which it was found; none of these depths is a property of gelatin.
- The threshold. The slowest shots stop on a dent without a channel: their tips do not strain an element of this size to the limit. With half of h more of them breach. The measured depths lie on straight lines down to the
  slowest shot and show no such threshold. Where dents agree at h and h x 2 ("yes" at 464 kg/m3, where h x 1/2 was not run), two meshes agree that nothing erodes, no more.
- The settings. A free bottom and a wider fine zone move the calibrated shots by less than a tenth, about their scatter; doubling K moves the rhombus by more than that.
- The prediction. One erosion strain for each shape, found at one shot, does not predict the slow shots, and the fast ones within the scatter and the mesh's error only. Depths near all six measured ones come out of this solver with
  the near wall only: it adds the resistance that lets a small erosion strain, which breaches at every speed, stop the particle at all."""
TURNED_READING = """Standing on a corner or on a face the square keeps its course to the bit: the scene is its own mirror image, so that nothing turns it. That course need not be a stable one. Turned by 20 degrees and free, it tumbles: the face that
looks down is pushed on one side of the centre. How far it has turned when it stops differs from replicate to replicate by tens of degrees, so that the end angle is not predictable here, while the depth hardly notices."""
