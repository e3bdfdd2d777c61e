// Included twice by vtkMediumFormulas.h, once for each number type.
#include "vtkMediumPhase.glsl"
#include "vtkMediumRayBox.glsl"
#include "vtkMediumSegment.glsl"
#include "vtkMediumTransmittance.glsl"
#undef PHASE_PI
#undef PHASE_LIMIT
