"""Relative viscosity of blood at a haematocrit, as measured.

    from blood import whole_blood, wide_tubes
"""

from results import find, read

FITS = "../bloodViscosity/reference/bulk_viscosity_vs_shear.csv"


def wide_tubes(H):
    """In wide tubes at high shear (Pries et al. 1992)."""
    return 1 + 2.2*((1 - H)**-0.8 - 1)/(0.55**-0.8 - 1)


def fits():
    """Rows of the fits to whole blood over the shear rate."""
    return read(find(FITS))


def whole_blood(H, rate):
    """The fit of Quemada at a shear rate [1/s] of the table."""
    row = next(row for row in fits() if row["H"] == H and row["shear_1_per_s"] == rate)
    return row["mu_rel_quemada"]
