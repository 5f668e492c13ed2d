import * as THREE from 'three';

const PER_ROW = 256;

/** In shaders: reads the two parts of the record to which a vertex belongs. */
export const READ_RECORD = `
uniform highp sampler2D records;
void readRecord(int vertices, out vec4 first, out vec4 second) {
  int i = gl_VertexID / vertices;
  ivec2 at = ivec2(2 * (i % ${PER_ROW}), i / ${PER_ROW});
  first = texelFetch(records, at, 0);
  second = texelFetch(records, at + ivec2(1, 0), 0);
}
vec3 unpackColour(float packed) {
  return vec3(floor(packed / 65536.0), floor(mod(packed, 65536.0) / 256.0), mod(packed, 256.0)) / 255.0;
}`;

/**
 * Eight numbers for each copy of a mesh, in a texture. Copies are drawn from one large mesh and not by instancing,
 * of which each instance costs half a millisecond in renderers without a graphics card.
 */
export class Records {
  data = new Float32Array(0);
  /** For the materials of all meshes that read the records. */
  readonly uniform: {value: THREE.DataTexture | null} = {value: null};
  capacity = 0;

  constructor(capacity: number) {
    this.reserve(capacity);
  }

  /** Makes room, with all numbers 0. Returns whether there was too little. */
  reserve(count: number): boolean {
    if (count <= this.capacity) {
      return false;
    }
    const rows = Math.ceil(1.3 * count / PER_ROW);
    this.capacity = rows * PER_ROW;
    this.data = new Float32Array(8 * this.capacity);
    this.uniform.value?.dispose();
    this.uniform.value = new THREE.DataTexture(this.data, 2 * PER_ROW, rows, THREE.RGBAFormat, THREE.FloatType);
    return true;
  }

  /** Sends the numbers to the renderer. */
  upload(): void {
    this.uniform.value!.needsUpdate = true;
  }
}

/** Returns a geometry with copies of another one. */
export function repeat(base: THREE.BufferGeometry, copies: number): THREE.BufferGeometry {
  const geometry = new THREE.BufferGeometry();
  const vertices = base.getAttribute('position').count;
  for (const [name, attribute] of Object.entries(base.attributes)) {
    const array = new Float32Array(attribute.array.length * copies);
    for (let copy = 0; copy < copies; ++copy) {
      array.set(attribute.array, copy * attribute.array.length);
    }
    geometry.setAttribute(name, new THREE.BufferAttribute(array, attribute.itemSize));
  }
  const corners = base.index!.array;
  const index = new Uint32Array(corners.length * copies);
  for (let i = 0; i < index.length; ++i) {
    index[i] = corners[i % corners.length] + vertices * Math.floor(i / corners.length);
  }
  geometry.setIndex(new THREE.BufferAttribute(index, 1));
  return geometry;
}

/** Returns a square with corners at 1 and -1. */
export function square(): THREE.BufferGeometry {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.Float32BufferAttribute([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0], 3));
  geometry.setIndex([0, 1, 2, 0, 2, 3]);
  return geometry;
}

/** Copies of a mesh, each of which reads its record: one draw call for all. */
export class Copies {
  readonly mesh: THREE.Mesh<THREE.BufferGeometry, THREE.ShaderMaterial>;
  private capacity = 0;

  constructor(private readonly base: THREE.BufferGeometry, records: Records,
              parameters: THREE.ShaderMaterialParameters) {
    const vertices = base.getAttribute('position').count;
    this.mesh = new THREE.Mesh(new THREE.BufferGeometry(), new THREE.ShaderMaterial({
      ...parameters, uniforms: {...parameters.uniforms, records: records.uniform},
      defines: {...parameters.defines, VERTICES: vertices},
    }));
    this.mesh.frustumCulled = false;
    this.mesh.matrixAutoUpdate = false;
    this.mesh.visible = false;
  }

  /** Shows as many copies as given. */
  show(count: number): void {
    if (count > this.capacity) {
      this.capacity = Math.ceil(1.3 * count);
      this.mesh.geometry.dispose();
      this.mesh.geometry = repeat(this.base, this.capacity);
    }
    this.mesh.geometry.setDrawRange(0, count * this.base.index!.count);
    this.mesh.visible = count > 0;
  }
}
