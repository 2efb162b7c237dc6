// SPDX-License-Identifier: GPL-3.0-or-later
// A reader's own meshes over a reload: in this browser's storage under a name that this tab alone has. A tab holds a lock as
// long as it lives, so that the next Joint3D deletes what closed ones have left.

const NAME = "joint3d-tab";
const LOCK = (tab) => `${NAME} ${tab}`;
const PATIENCE = 1000; // ms: a page that is loaded again may still hold its lock

const result = (request) => new Promise((resolve, reject) => {
  request.onsuccess = () => resolve(request.result);
  request.onerror = () => reject(request.error);
});

async function store(use) {
  const opening = indexedDB.open("joint3d", 1);
  opening.onupgradeneeded = () => opening.result.createObjectStore("meshes");
  const base = await result(opening);
  try {
    return await use(base.transaction("meshes", "readwrite").objectStore("meshes"));
  } finally {
    base.close();
  }
}

/** Whether this tab got the lock of that name, which it then holds for good. */
const locked = (tab) => new Promise((resolve) => {
  const signal = AbortSignal.timeout(PATIENCE);
  navigator.locks.request(LOCK(tab), { signal }, () => { resolve(true); return new Promise(() => {}); }).catch(() => resolve(false));
});

export class KeptMeshes {
  constructor() {
    this.tab = this.begin();
    this.tab.then((tab) => this.sweep(tab)).catch(() => {});
  }

  /** The name of this tab. A copy of a tab has its name and what it kept, until it has a name of its own. */
  async begin() {
    const before = sessionStorage.getItem(NAME);
    if (before && await locked(before)) return before;
    const tab = String(Math.random()).slice(2);
    await locked(tab);
    sessionStorage.setItem(NAME, tab);
    if (before) await store(async (place) => { await result(place.put(await result(place.get(before)), tab)); });
    return tab;
  }

  async keep(meshes) {
    const tab = await this.tab;
    await store((place) => result(place.put(meshes, tab)));
  }

  /** What this tab has kept, or undefined. */
  async found() {
    const tab = await this.tab;
    return store((place) => result(place.get(tab)));
  }

  /** Deletes what tabs kept that are closed. */
  async sweep(tab) {
    const { held, pending } = await navigator.locks.query();
    const alive = [LOCK(tab), ...[...held, ...pending].map(({ name }) => name)];
    await store(async (place) => {
      const gone = (await result(place.getAllKeys())).filter((key) => !alive.includes(LOCK(key)));
      await Promise.all(gone.map((key) => result(place.delete(key))));
    });
  }
}
