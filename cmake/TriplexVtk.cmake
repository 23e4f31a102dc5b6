# SPDX-FileCopyrightText: The Triplex authors
# SPDX-License-Identifier: GPL-3.0-or-later

# The parts of VTK that io, contour, flow and render use. Always with COMPONENTS: a bare find_package(VTK) asks for
# Qt on some systems. Used by the build and by the installed package alike.
set(TRIPLEX_VTK_IO CommonCore CommonDataModel CommonExecutionModel FiltersGeneral IOCore IOXML IOLegacy
  IOParallelXML)
set(TRIPLEX_VTK_RENDER CommonColor CommonCore CommonDataModel CommonExecutionModel FiltersCore FiltersGeneral
  FiltersGeometry FiltersHybrid FiltersSources IOImage IOXML ImagingCore RenderingCore RenderingFreeType RenderingOpenGL2)
set(TRIPLEX_VTK_FLOW CommonCore CommonDataModel CommonExecutionModel FiltersFlowPaths FiltersGeneral)
set(triplex_vtk_components ${TRIPLEX_VTK_IO} ${TRIPLEX_VTK_FLOW} ${TRIPLEX_VTK_RENDER})
list(REMOVE_DUPLICATES triplex_vtk_components)
find_package(VTK 9.1 REQUIRED COMPONENTS ${triplex_vtk_components})
list(TRANSFORM TRIPLEX_VTK_IO PREPEND VTK::)
list(TRANSFORM TRIPLEX_VTK_FLOW PREPEND VTK::)
list(TRANSFORM TRIPLEX_VTK_RENDER PREPEND VTK::)
