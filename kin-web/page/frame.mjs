/** The moving page in a frame. A new report gets a new frame, which comes to the front once it moves. */

/**
 * @param {HTMLElement} parent
 * @param {{markup: string, style: string, script: string}} view
 * @param {(design: {name: string, dimension: string, value: number}[]) => void} moved what happens after a slider moved
 */
export function createFrames(parent, view, moved) {
  let front = null;
  let back = null;

  function keptBy(frame) {
    return new Promise((resolve) => {
      const timer = setTimeout(() => resolve(null), 300);
      frame.kept = (kept) => {
        clearTimeout(timer);
        resolve(kept);
      };
      frame.element.contentWindow.postMessage({ ask: "keep" }, "*");
    });
  }

  addEventListener("message", async ({ source, data }) => {
    const frame = [front, back].find((one) => one?.element.contentWindow === source);
    if (!frame) {
      return;
    }
    if (data.ready) {
      const kept = front?.key === frame.key ? await keptBy(front) : null;
      source.postMessage({ report: frame.report, kept }, "*");
    } else if (data.shown && frame === back) {
      front?.element.remove();
      front = back;
      back = null;
      front.element.classList.remove("behind");
    } else if (data.kept) {
      frame.kept?.(data.kept);
    } else if (data.design && frame === front) {
      moved(data.design);
    }
  });

  return {
    show(report) {
      back?.element.remove();
      const element = document.createElement("iframe");
      element.title = `${report.title}, moving`;
      element.className = "behind";
      element.srcdoc =
        `<!doctype html><html lang="en"><head><meta charset="utf-8">` +
        `<meta name="viewport" content="width=device-width, initial-scale=1"><title>kin</title>` +
        `<style>${view.style}</style></head><body>${view.markup}` +
        `<script type="module">${view.script}</script></body></html>`;
      // a mechanism of another name is looked at anew
      back = { element, report, key: report.name, kept: null };
      parent.append(element);
    },
  };
}
