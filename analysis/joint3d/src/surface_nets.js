// SPDX-License-Identifier: GPL-3.0-or-later
// The surface on which a field on a grid is zero ("surface nets": a vertex in each cell that the surface crosses, at the mean
// of the crossings of its edges; a quadrangle round each edge of the grid that it crosses).

/** A grid of numbers: size[0] x size[1] x size[2] places, `step` apart, from `low` on. */
export function makeGrid(low, high, step, value) {
  const size = low.map((from, k) => Math.ceil((high[k] - from) / step) + 1);
  return { low, step, size, values: new Float32Array(size[0] * size[1] * size[2]).fill(value), strides: [1, size[0], size[0] * size[1]] };
}

const bits = (corner) => [corner & 1, (corner >> 1) & 1, corner >> 2];

/** The mean of the crossings of the edges of the cell at `at`, in steps from its first corner, or null. */
function crossing({ values, strides }, at) {
  const corner = Array.from({ length: 8 }, (_, c) => values[at + bits(c).reduce((sum, bit, k) => sum + bit * strides[k], 0)]);
  const sum = [0, 0, 0];
  let count = 0;
  for (let a = 0; a < 8; a += 1) {
    for (let axis = 0; axis < 3; axis += 1) {
      const b = a | (1 << axis);
      if (a === b || corner[a] < 0 === corner[b] < 0) continue;
      const place = bits(a);
      place[axis] += corner[a] / (corner[a] - corner[b]);
      place.forEach((x, k) => { sum[k] += x; });
      count += 1;
    }
  }
  return count ? sum.map((x) => x / count) : null;
}

/** { positions, faces } of the surface; the inside, below zero, lies behind the faces. */
export function surfaceOf(grid) {
  const { low, step, size, values, strides } = grid;
  const vertex = new Map();
  const positions = [];
  const faces = [];
  for (let k = 0; k < size[2] - 1; k += 1) for (let j = 0; j < size[1] - 1; j += 1) for (let i = 0; i < size[0] - 1; i += 1) {
    const at = i + j * strides[1] + k * strides[2];
    const inside = crossing(grid, at);
    if (!inside) continue;
    vertex.set(at, positions.length / 3);
    [i, j, k].forEach((index, axis) => positions.push(low[axis] + step * (index + inside[axis])));
  }
  vertex.forEach((_, at) => [0, 1, 2].forEach((axis) => {
    if (values[at] < 0 === values[at + strides[axis]] < 0) return;
    const [u, v] = [strides[(axis + 1) % 3], strides[(axis + 2) % 3]];
    const round = [at, at - u, at - u - v, at - v].map((cell) => vertex.get(cell));
    if (round.includes(undefined)) return; // at the border of the grid
    const [a, b, c, d] = values[at] < 0 ? round : round.reverse();
    faces.push(a, b, c, a, c, d);
  }));
  return { positions, faces };
}
