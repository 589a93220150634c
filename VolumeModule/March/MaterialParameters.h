#ifndef Varimarch_March_MaterialParameters_h
#define Varimarch_March_MaterialParameters_h

#include "March/VolumeParametersBuilder.h"

namespace varimarch
{

/// Sets the numbers of the tables that scalars are looked up in.
void SetTables(VolumeParameters& parameters, const VolumeMarch& march,
  const VolumeResources& volume, const Mappings& mappings);

/// Sets the numbers of light, gradient opacity and mixtures.
void SetMaterials(VolumeParameters& parameters, const VolumeMarch& march,
  const VolumeResources& volume, const Mappings& mappings);

}

#endif
