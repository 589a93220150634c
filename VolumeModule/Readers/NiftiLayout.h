#ifndef Varimarch_Readers_NiftiLayout_h
#define Varimarch_Readers_NiftiLayout_h

// The C structs of NIfTI's headers and the codes of its data types. Both libraries below publish
// the definitions of the standard: vtk-dicom, which exists for Debian's VTK, and nifticlib, which
// needs no VTK.
#if __has_include("vtkNIFTIPrivate.h")
#include "vtkNIFTIPrivate.h"
#else
#include <nifti/nifti1.h>
#include <nifti/nifti2.h>
#endif

#endif
