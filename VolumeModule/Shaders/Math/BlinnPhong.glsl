// The model of Blinn, "Models of light reflection for computer synthesized pictures" (SIGGRAPH
// 1977). A reflectance holds the coefficients of ambient, diffuse and specular light and the
// specular power.

// The factor that makes a normal a unit vector; 0 where there is no normal.
float InverseLength(vec3 normal)
{
  float squared = dot(normal, normal);
  return squared > 1e-36f ? inversesqrt(squared) : 0.0f;
}

// The cosine between a normal of any length and the direction to the eye, which sees both sides of
// a surface; 0 where there is no normal.
// @param towardsEye  the product of the normal and the direction of the ray
float FacingEye(vec3 normal, float towardsEye)
{
  return min(abs(towardsEye) * InverseLength(normal), 1.0f);
}

// The color of a surface under a light at the eye. The half vector is the direction to the eye.
// @param litPart  the part of the light that the surface receives
vec3 LitFromEye(
  vec3 color, float facing, float litPart, vec4 reflectance, vec3 diffuseLight, vec3 specularLight)
{
  float diffuse = litPart * reflectance.y * facing;
  float specular = litPart * reflectance.z * pow(facing, reflectance.w);
  return color * (reflectance.x + diffuse * diffuseLight) + specular * specularLight;
}

// The cosine by which a light in a direction lights a surface.
// @param backsLit  1 if both sides of a surface are lit, else 0
float Facing(vec3 normal, vec3 direction, float backsLit)
{
  float cosine = dot(normal, direction);
  return max(cosine, -backsLit * cosine);
}

// The cosine between a normal and the half vector of a light that the surface faces; 1e-6 instead
// of less, so that powers of it are numbers.
float Shining(vec3 normal, vec3 toLight, vec3 toEye, float backsLit)
{
  vec3 halfway = toLight + toEye;
  float cosine =
    Facing(normal, halfway, backsLit) * inversesqrt(max(dot(halfway, halfway), 1e-30f));
  return clamp(cosine, 1e-6f, 1.0f);
}

// The diffuse and the specular part of a light that a surface reflects to the eye.
vec2 Reflected(vec3 normal, vec3 toLight, vec3 toEye, float power, float backsLit)
{
  float facing = Facing(normal, toLight, backsLit);
  float shining = pow(Shining(normal, toLight, toEye, backsLit), power);
  return vec2(facing, facing > 0.0f ? shining : 0.0f);
}

// The color of a surface under several lights.
// @param diffuse, specular  the sums of what the surface reflects of all lights
vec3 LitByAll(
  vec3 color, float litPart, vec4 reflectance, vec3 ambientLight, vec3 diffuse, vec3 specular)
{
  return color * (reflectance.x * ambientLight + litPart * reflectance.y * diffuse) +
    litPart * reflectance.z * specular;
}

// The part of a near light that reaches a point.
// @param attenuation  constant, per mm, per mm^2
// @param shinesAlong  the axis of its cone
// @param exponent  the power by which light weakens towards the edge of the cone
float LightReach(vec3 attenuation, float distanceMm, vec3 toLight, vec3 shinesAlong,
  float cosineOfCone, float exponent)
{
  float inCone = -dot(toLight, shinesAlong);
  float reach = 1.0f / (attenuation.x + distanceMm * (attenuation.y + distanceMm * attenuation.z));
  float shaped = reach * pow(clamp(inCone, 1e-6f, 1.0f), exponent);
  return inCone >= cosineOfCone ? shaped : 0.0f;
}
