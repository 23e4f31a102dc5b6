# SPDX-FileCopyrightText: The Triplex authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The open channel.
extract channel "$root/data/channel.vtu" --tensor tensor
draw channel channel --sheet --columns 2 --size 700x450 --view -70,30 --no-nodes
