#ifndef Varimarch_March_MaterialParameters_h
#define Varimarch_March_MaterialParameters_h

#include "March/VolumeParametersBuilder.h"

namespace varimarch
{

/// Sets the parameters of the tables that scalars are looked up in.
void SetTables(VolumeParameters& parameters, const VolumeMarch& march,
  const VolumeResources& volume, const Mappings& mappings);

/// Sets the parameters of lights, gradient opacity and mixtures.
void SetMaterials(VolumeParameters& parameters, const VolumeMarch& march,
  const VolumeResources& volume, const Mappings& mappings);

}

#endif
