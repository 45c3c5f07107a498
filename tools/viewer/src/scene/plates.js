/**
 * A plate lies on every tile below it, a piece on each (sim_hw/world/terrain.hpp adds its height to the tile's).
 * @returns {object[]} plates, each with `base_m`
 */
export function piecesOnTiles(plate, tiles) {
  if (!tiles || plate.kind !== "plate") return [{ ...plate, base_m: 0 }];
  const { edge_m, x0_m, y0_m, nx, ny } = tiles;
  const [west, south] = [0, 1].map((axis) => plate.centre_m[axis] - plate.size_m[axis] / 2);
  const [east, north] = [0, 1].map((axis) => plate.centre_m[axis] + plate.size_m[axis] / 2);
  const within = (cell, count) => Math.min(Math.max(cell, 0), count - 1);
  const pieces = [];
  for (let x = within(Math.floor((west - x0_m) / edge_m), nx); x <= within(Math.floor((east - x0_m) / edge_m), nx); x++) {
    for (let y = within(Math.floor((south - y0_m) / edge_m), ny); y <= within(Math.floor((north - y0_m) / edge_m), ny); y++) {
      const [from_x, to_x] = [Math.max(west, x0_m + x * edge_m), Math.min(east, x0_m + (x + 1) * edge_m)];
      const [from_y, to_y] = [Math.max(south, y0_m + y * edge_m), Math.min(north, y0_m + (y + 1) * edge_m)];
      if (to_x <= from_x || to_y <= from_y) continue;
      pieces.push({
        ...plate, centre_m: [(from_x + to_x) / 2, (from_y + to_y) / 2], size_m: [to_x - from_x, to_y - from_y],
        base_m: tiles.height_m[x * ny + y],
      });
    }
  }
  return pieces;
}
