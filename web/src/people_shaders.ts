import * as THREE from 'three';
import {ELBOW, HIP, KNEE, SHOULDER} from './figure_mesh';
import {READ_RECORD} from './records';

/** Pictures of figures: from how many sides, and in how many poses; the last one stands. */
export const ANGLES = 16;
export const POSES = 13;
/** Size of a picture [m], and height of its middle [m]. */
export const BOX = 2;
export const MIDDLE = 0.9;
const STORED_LIGHT = 0.8;
const USUAL_RADIUS = 0.25;  // [m] of a person of usual size

const CLOTH_COLOUR = `
uniform vec3 cloths[18];
float sizeOf(float radius) {
  return 0.7 + 0.3 * clamp(radius / ${USUAL_RADIUS}, 0.4, 1.4);
}
vec3 clothColour(float cloth, float person, vec3 shirt) {
  if (cloth < 0.5) return shirt;
  float choice = floor(fract(sin(person * 12.9898 + cloth * 78.233) * 43758.5453) * 6.0);
  if (cloth < 1.5) return cloths[int(choice)];
  if (cloth < 2.5) return cloths[6 + int(choice)];
  if (cloth < 3.5) return cloths[12 + int(choice)];
  return vec3(0.16, 0.15, 0.17);
}`;

const FIGURE_VERTICES = `${READ_RECORD}
${CLOTH_COLOUR}
attribute vec3 limb;  // cloth, leg (1) or arm (2) with the sign of its side, whether below knee or elbow
varying vec3 shade;

void bend(inout vec3 p, inout vec3 n, float pivot, float angle) {
  float s = sin(angle), c = cos(angle);
  p = vec3(c * p.x - s * (p.z - pivot), p.y, s * p.x + c * (p.z - pivot) + pivot);
  n = vec3(c * n.x - s * n.z, n.y, s * n.x + c * n.z);
}

void main() {
  vec4 place, look;  // x, y, heading, phase of the walk; radius, swing, number of the person, colour
  readRecord(VERTICES, place, look);
  float size = sizeOf(look.x);
  vec3 p = position, n = normal;
  float kind = abs(limb.y);
  float side = sign(limb.y);
  float phase = place.w + (side < 0.0 ? 3.14159265 : 0.0);
  float swing = look.y * sin(phase);
  if (kind > 1.5) {
    if (limb.z > 0.5) bend(p, n, ${ELBOW}, 0.22 + 0.5 * look.y - 0.3 * swing);
    bend(p, n, ${SHOULDER}, -0.8 * swing);
  } else if (kind > 0.5) {
    float lift = max(cos(phase), 0.0);
    if (limb.z > 0.5) bend(p, n, ${KNEE}, -2.2 * look.y * lift * lift - 0.05);
    bend(p, n, ${HIP}, swing + 0.15 * look.y * lift * lift);
  } else {
    float lean = 0.05 * look.y;
    p.x += lean * (p.z - ${HIP});
  }
  p.z -= ${HIP} * (1.0 - cos(swing)) * 0.9;
  float s = sin(place.z), c = cos(place.z);
  vec3 world = vec3(place.xy + size * vec2(c * p.x - s * p.y, s * p.x + c * p.y), size * p.z);
  vec3 direction = vec3(c * n.x - s * n.y, s * n.x + c * n.y, n.z);
  float light = 0.66 + 0.3 * dot(direction, vec3(-0.48, -0.6, 0.64)) + 0.08 * direction.z + 0.06 * (p.z - 0.9);
  gl_Position = projectionMatrix * viewMatrix * vec4(world, 1.0);
#ifdef ATLAS
  vec2 cell = vec2(gl_VertexID / VERTICES % ${ANGLES}, gl_VertexID / VERTICES / ${ANGLES});
  gl_Position.xy = (gl_Position.xy + 2.0 * cell + 1.0) / vec2(${ANGLES}, ${POSES}) - 1.0;
  shade = ${STORED_LIGHT} * light * vec3(limb.x < 0.5, limb.x > 0.5 && limb.x < 1.5, limb.x > 1.5 && limb.x < 2.5);
#else
  shade = clothColour(limb.x, look.z, unpackColour(look.w)) * light;
#endif
}`;

const FIGURE_PIXELS = `
varying vec3 shade;
void main() { gl_FragColor = vec4(shade, 1.0); }`;

const CLOTHS = [
  0x2f3e5c, 0x4a4f57, 0x6b5b4b, 0x22262e, 0x5d6f86, 0x8a8172,  // trousers
  0xf0c8a6, 0xe0ac82, 0xc68a5e, 0x9a6541, 0x6d452c, 0xf3d3b8,  // skin
  0x2a211c, 0x4b3323, 0x7a5636, 0xb58d55, 0x1c1a1b, 0x8e8a86,  // hair
].map((colour) => new THREE.Color(colour));

/** Walking figures. */
export const FIGURE_SHADERS = {
  vertexShader: FIGURE_VERTICES, fragmentShader: FIGURE_PIXELS,
};

/** One point for each person, whose size [m] on the screen is `extent`. */
const POINT_VERTICES = `
attribute vec4 place;
attribute vec4 look;
uniform float screenHeight;
${CLOTH_COLOUR}
vec3 unpackColour(float packed) {
  return vec3(floor(packed / 65536.0), floor(mod(packed, 65536.0) / 256.0), mod(packed, 256.0)) / 255.0;
}
void setPoint(float height, float extent) {
  gl_Position = projectionMatrix * viewMatrix * vec4(place.xy, height, 1.0);
  gl_PointSize = max(projectionMatrix[1][1] * screenHeight * 0.5 * extent / gl_Position.w, 3.0);
}`;

/** In shaders: the place in a disc on the floor, 1 at its rim, as it is seen by the camera. */
const FLOOR_PLACE = `
uniform float flatness;  // cosine of the angle between the view and straight down
vec2 floorPlace() {
  return (2.0 * gl_PointCoord - 1.0) * vec2(1.0, -1.0 / flatness);
}`;

/** Discs with a bright nose where they look. */
export const DISC_SHADERS = {
  vertexShader: `${POINT_VERTICES}
uniform float azimuth;
varying vec3 tint;
varying vec2 ahead;
void main() {
  setPoint(0.03, 2.0 * look.x);
  tint = unpackColour(look.w);
  ahead = 0.55 * vec2(cos(place.z - azimuth), sin(place.z - azimuth));
}`,
  fragmentShader: `${FLOOR_PLACE}
varying vec3 tint;
varying vec2 ahead;
void main() {
  vec2 at = floorPlace();
  float d = dot(at, at);
  if (d > 1.0) discard;
  vec2 nose = at - ahead;
  vec3 shade = tint * (d > 0.7 ? 0.72 : 1.0);
  gl_FragColor = vec4(mix(shade, vec3(1.0), dot(nose, nose) < 0.09 ? 0.75 : 0.0), 1.0);
}`,
};

/** Soft shadows under figures. */
export const SHADOW_SHADERS = {
  vertexShader: `${POINT_VERTICES}
void main() { setPoint(0.012, 3.0 * look.x); }`,
  fragmentShader: `${FLOOR_PLACE}
void main() {
  vec2 at = floorPlace();
  gl_FragColor = vec4(0.1, 0.13, 0.2, 0.34 * clamp(1.3 * (1.0 - dot(at, at)), 0.0, 1.0));
}`,
};

/** Pictures of figures, each of the side and pose that are seen. */
export const SPRITE_SHADERS = {
  vertexShader: `${POINT_VERTICES}
uniform float azimuth;
varying vec3 shirt;
varying vec3 trousers;
varying vec3 skin;
varying vec2 cell;
void main() {
  float size = sizeOf(look.x);
  setPoint(${MIDDLE} * size, ${BOX.toFixed(1)} * size);
  float turn = fract((place.z - azimuth) / 6.2831853 + 0.5 / ${ANGLES}.0);
  float pose = look.y < 0.05 ? ${POSES - 1}.0 : floor(fract(place.w / 6.2831853) * ${POSES - 1}.0);
  cell = vec2(floor(turn * ${ANGLES}.0), pose);
  shirt = unpackColour(look.w);
  trousers = clothColour(1.0, look.z, shirt);
  skin = clothColour(2.0, look.z, shirt);
}`,
  fragmentShader: `
uniform sampler2D atlas;
varying vec3 shirt;
varying vec3 trousers;
varying vec3 skin;
varying vec2 cell;
void main() {
  vec2 at = (floor(cell + 0.5) + vec2(gl_PointCoord.x, 1.0 - gl_PointCoord.y)) / vec2(${ANGLES}, ${POSES});
  vec4 light = texture2D(atlas, at);
  if (light.a < 0.5) discard;
  light.rgb /= ${STORED_LIGHT};
  float hair = max(1.0 - 1.4 * (light.r + light.g + light.b), 0.0);
  gl_FragColor = vec4(light.r * shirt + light.g * trousers + light.b * skin + hair * vec3(0.2, 0.17, 0.16), 1.0);
}`,
};

/** Colours of clothes for the shaders that choose them. */
export const CLOTH_UNIFORM = {cloths: {value: CLOTHS}};
