#ifndef Varimarch_Testing_VtkMapper_h
#define Varimarch_Testing_VtkMapper_h

#include "Regression/RegressionCase.h"

/// Lets VTK's own GPU mapper draw the volumes of a scene, with all settings that both mappers have.
void UseVtkMapper(const RegressionScene& scene);

#endif
