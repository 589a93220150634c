// Emission and absorption, front to back. A part of the ray is taken as homogeneous, for which the
// volume rendering integral has a closed form (Max, "Optical models for direct volume rendering",
// IEEE TVCG 1995, eq. 7): it emits color * absorption and lets exp(-depth) through.

struct Accumulation
{
  vec3 color;          // premultiplied
  float transmittance; // part of the light from behind that is left
};

Accumulation BlendBegin()
{
  return Accumulation(vec3(0.0), 1.0);
}

Accumulation BlendPart(Accumulation sum, vec3 color, float depth)
{
  // An opaque material has a huge extinction; beyond 100 nothing of a float is left anyway.
  float absorbed = Absorption(min(depth, 100.0));
  sum.color += sum.transmittance * absorbed * color;
  sum.transmittance *= 1.0 - absorbed;
  return sum;
}

float BlendState(Accumulation sum)
{
  return sum.transmittance;
}

bool BlendFinished(Accumulation sum)
{
  return sum.transmittance < earlyTerminationTransmittance;
}

vec4 BlendResult(Accumulation sum)
{
  return vec4(sum.color, 1.0 - sum.transmittance);
}

vec4 BlendKept(Accumulation sum)
{
  return vec4(sum.color, 1.0 - sum.transmittance);
}

Accumulation BlendResumed(vec4 kept)
{
  return Accumulation(kept.rgb, 1.0 - kept.a);
}
