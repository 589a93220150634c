#ifndef Varimarch_Testing_RefinedMapper_h
#define Varimarch_Testing_RefinedMapper_h

// The driver of VTK's tests includes this file and calls the function declared here.
#include <vtkTestingObjectFactory.h>

void RegisterRefinedMapper();

#endif
