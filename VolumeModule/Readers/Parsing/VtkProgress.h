#ifndef Varimarch_Readers_Parsing_VtkProgress_h
#define Varimarch_Readers_Parsing_VtkProgress_h

#include "Readers/VolumeFile.h"

class vtkAlgorithm;

namespace varimarch
{

/// Updates the first output of a VTK algorithm and forwards its progress.
/// @throws ReadCancelled after the algorithm has returned
void UpdateWithProgress(vtkAlgorithm* algorithm, ReadProgress& progress);

}

#endif
