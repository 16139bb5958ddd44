// {{name}}: a material for three.js made by Nacre (Ashikhmin, Premoze, Shirley 2000).
//
//     import {material} from {{file}};
//     const mesh = new THREE.Mesh(new THREE.SphereGeometry(1, 128, 64), material());
//
// It is lit by the scene's directional and point lights{{ambient}}, without shadows. Tangents: the geometry's
// `tangent` attribute with material({tangents: true}); else they run around the object's y axis, as east does on a globe.
import * as THREE from "three";

// The function {{prefix}}_brdf(k1, k2), and the tables that it reads.
export const glsl = {{glsl}};
const rows = {{rows}};
const packed = "{{tables}}";

export function tables() {
    const bytes = Uint8Array.from(atob(packed), (c) => c.charCodeAt(0));
    const texture = new THREE.DataTexture(new Float32Array(bytes.buffer), 1024, rows, THREE.RedFormat, THREE.FloatType);
    texture.needsUpdate = true;
    return texture;
}

const vertex = `
varying vec3 view_position, view_normal, view_tangent;
#ifdef USE_OWN_TANGENT
attribute vec4 tangent;
#endif
void main() {
    vec4 place = modelViewMatrix * vec4(position, 1.0);
    view_position = place.xyz;
    view_normal = normalMatrix * normal;
#ifdef USE_OWN_TANGENT
    view_tangent = (modelViewMatrix * vec4(tangent.xyz, 0.0)).xyz;
#else
    vec3 east = cross(vec3(0.0, 1.0, 0.0), normal);
    view_tangent = (modelViewMatrix * vec4(dot(east, east) > 1e-12 ? east : vec3(1.0, 0.0, 0.0), 0.0)).xyz;
#endif
    gl_Position = projectionMatrix * place;
}`;

const fragment = `
precision highp sampler2D;
#include <common>
#include <lights_pars_begin>
varying vec3 view_position, view_normal, view_tangent;
${glsl}
void main() {
    vec3 normal = normalize(gl_FrontFacing ? view_normal : -view_normal);
    vec3 tangent = normalize(view_tangent - normal * dot(normal, view_tangent));
    mat3 frame = mat3(tangent, cross(normal, tangent), normal);
    vec3 viewer = (isOrthographic ? vec3(0.0, 0.0, 1.0) : normalize(-view_position)) * frame;
    vec3 sum = vec3(0.0);
#if NUM_DIR_LIGHTS > 0
    for (int i = 0; i < NUM_DIR_LIGHTS; ++i) {
        vec3 k1 = directionalLights[i].direction * frame;
        if (k1.z > 0.0) sum += {{prefix}}_brdf(k1, viewer) * directionalLights[i].color * k1.z;
    }
#endif
#if NUM_POINT_LIGHTS > 0
    for (int i = 0; i < NUM_POINT_LIGHTS; ++i) {
        vec3 way = pointLights[i].position - view_position;
        vec3 k1 = normalize(way) * frame;
        float part = getDistanceAttenuation(length(way), pointLights[i].distance, pointLights[i].decay);
        if (k1.z > 0.0) sum += {{prefix}}_brdf(k1, viewer) * pointLights[i].color * (part * k1.z);
    }
#endif
{{ambient_light}}    gl_FragColor = vec4(sum, 1.0);
#include <tonemapping_fragment>
#include <colorspace_fragment>
}`;

export function material({tangents = false} = {}) {
    const made = new THREE.ShaderMaterial({
        lights: true, vertexShader: vertex, fragmentShader: fragment, defines: tangents ? {USE_OWN_TANGENT: 1} : {},
        uniforms: THREE.UniformsUtils.clone(THREE.UniformsLib.lights)});
    made.uniforms.{{prefix}}_data = {value: tables()};
    return made;
}
