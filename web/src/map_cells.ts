import {GridMap} from './messages';

const OCCUPIED = 100;

/** A part of a grid whose cells are all occupied. */
export interface Rectangle {
  column: number;
  row: number;
  width: number;
  height: number;
}

/** Returns the cells of a map, row by row from below. */
export function mapCells(map: GridMap): Uint8Array {
  const text = atob(map.cells);
  if (text.length !== map.width * map.height) {
    throw new Error(`the map has ${text.length} cells, expected ${map.width} x ${map.height}`);
  }
  return Uint8Array.from(text, (character) => character.charCodeAt(0));
}

/** Covers the occupied cells of a map by few rectangles. */
export function occupiedRectangles({width, height}: GridMap, cells: Uint8Array): Rectangle[] {
  const isFree = (column: number, row: number) => cells[row * width + column] !== OCCUPIED;
  const covered = new Uint8Array(cells.length);
  const rectangles: Rectangle[] = [];
  for (let row = 0; row < height; ++row) {
    for (let column = 0; column < width; ++column) {
      if (isFree(column, row) || covered[row * width + column]) {
        continue;
      }
      let right = column;
      while (right < width && !isFree(right, row) && !covered[row * width + right]) {
        ++right;
      }
      let top = row + 1;
      while (top < height && rowIsOccupied(cells, covered, top * width + column, top * width + right)) {
        ++top;
      }
      for (let y = row; y < top; ++y) {
        covered.fill(1, y * width + column, y * width + right);
      }
      rectangles.push({column, row, width: right - column, height: top - row});
    }
  }
  return rectangles;
}

function rowIsOccupied(cells: Uint8Array, covered: Uint8Array, begin: number, end: number): boolean {
  for (let i = begin; i < end; ++i) {
    if (cells[i] !== OCCUPIED || covered[i]) {
      return false;
    }
  }
  return true;
}
