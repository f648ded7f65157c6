"""The words of docs/verification/cross_check.md."""

RIDGE = """{table}

percal's ridge is not flat: {least:.1f} to {most:.1f} um at 14 elements per radius, {above} % above 26 um on average. alpha 8.5 was inferred from depths with soft springs and 10 elements per radius."""

PAGE = """# Cross-check: the same impacts by other codes

Written by `docs/verification/make_cross_check.py` ({machine}, one thread, {cpu:.0f} s of processor time in percal). Depths are means ± standard
errors of the mean; sd is the standard deviation of one run. Processor times are from a machine that others were using at the time: they compare only roughly.

## Against an independent code

A code written before percal, as a throw-away, and none of it taken over, solves the same equations ([theory/impact.md](../theory/impact.md)) with the same element, viscosity (0.06, 0.6), hourglass stiffness (0.5 mu),
erosion rule and grading. Its figures are typed into cross_check_figures.py: five runs each, at the meshes and speeds of percal's five replicates about 10 elements per radius, one rate, a time-step factor of 0.8, which percal ran with too. What differs
is the contact: springs there, of stiffness kappa m/dt_ref^2, impulses here, the limit of stiff springs ([0013](../decisions/0013-contact-by-impulses.md)). Depths in radii, differences ± their standard error.

{codes}

With stiff springs the other code comes to percal's depths in eight of twelve cases; with soft ones it is off by up to a fifth where the material is stiff at its erosion strain. So kappa 0.6 was a part of the result, and impulses need
none. U, 2 % apart, is what the springs' remaining give is worth where hardly anything erodes. The light sphere (P) is where the two contacts truly differ: springs throw nodes back, which as they are freed carry away 0.41 of the impact
energy (0.47 with a length), while a node struck by an impulse goes on as fast as the sphere. A sphere sixteen times as heavy as what it throws does not feel it; one as light as the target does, by 7 % and 19 %. Which of the two gelatin does is
not known (0013). Alpha -6, where runs scatter by 6 to 9 %, is 12 ± 4 % apart; why has not been found.

### At the old contact

percal had springs of kappa 0.6 once, and then these depths (means of three runs, good to 1 to 2 %), but for F those of the other code within the scatter:

{old}

## Beside the figures of others

percal's defaults, ten runs each. The material is alpha 8.5 with mu as LS-DYNA's MU1 (the true modulus is 4.25 times the one given). alpha is not from
these groups but was inferred from their depths, so the ridge is a fit and not a prediction; K = 50 mu for gold, and as percal chooses it (Mach number below 0.3) for gelatin. The other code's figures are single runs at contact stiffness 0.156 and scatter by 1 to 2 %.

### The ridge: six pairs that give 26 um

{ridge}

### Gold into skin

15 MPa as given, erosion strain 0.7.

{gold}

### Steel of 3.18 mm into gelatin

113 kPa as given, erosion strain 0.7, 10 elements per radius. The other code had K = 50 mu.

{gelatin}

### OpenRadioss

LAW42 with Mu_1 = 15 MPa, alpha 8.5, first principal engineering strain 0.7, axisymmetric, on meshes of 7 and 10 elements per radius; single runs of the planning study, radii. Its contact is its own. percal:
45 radii deep; where the mesh is not given both are shown.

{radioss}

What makes the differences (its contact, its element, its rule of erosion) has not been looked into; its own scatter is known from one line only (4 %, setting S at 7). Setting S took OpenRadioss 32 and 85 s of processor time at 7 and 10 elements per radius, percal {seven:.2f} and {ten:.2f} s.
"""
