# SPDX-FileCopyrightText: The Triplex authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Vortex core lines of the Arnold-Beltrami-Childress flow against balanced and complex neutral surfaces.
trace abc_cores abc.vtu --follow none --vortex-cores velocity
trace abc_cores_all abc.vtu --follow none --vortex-cores velocity --unfiltered
